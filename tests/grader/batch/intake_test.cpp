#include "batch/intake.h"

#include "batch/times.h"
#include "batch/zips.h"
#include "process/run.h"
#include "report/report.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

namespace testat {
namespace {
namespace fs = std::filesystem;

constexpr std::int64_t monday = 1'795'000'000;  // s
constexpr std::int64_t day = 86'400;            // s

class TakeIn : public testing::Test {
protected:
    Intake zip(std::vector<ZipItem> const& items, std::optional<std::int64_t> deadline = {})
    {
        write_zip(root_.path() / "download.zip", items);
        fs::remove_all(scratch_);
        return take_in(root_.path() / "download.zip", scratch_, deadline);
    }

    /// The same entries as files in folders.
    Intake folder(std::vector<ZipItem> const& items, std::string const& below = "")
    {
        fs::path const base = root_.path() / "unpacked";
        for (auto const& item : items)
            put(base, item);
        return take_in(base / below, scratch_, {});
    }

    std::string xlsx(std::vector<std::vector<std::string>> const& rows)
    {
        write_xlsx(root_.path() / "table.xlsx", rows);
        return bytes_of(root_.path() / "table.xlsx");
    }

    TemporaryDirectory root_;
    fs::path scratch_ = root_.path() / "scratch";

private:
    static void put(fs::path const& base, ZipItem const& item)
    {
        fs::create_directories(item.name.back() == '/' ? base / item.name : (base / item.name).parent_path());
        if (item.name.back() != '/')
            write_file(base / item.name, item.bytes);
    }
};

bool has_remark(Intake const& intake, std::string const& words)
{
    return std::any_of(intake.remarks.begin(), intake.remarks.end(),
                       [&](auto const& remark) { return remark.find(words) != std::string::npos; });
}

std::vector<std::string> students(Intake const& intake)
{
    std::vector<std::string> all;
    for (auto const& upload : intake.uploads)
        all.push_back(upload.student);
    return all;
}

using Names = std::vector<std::string>;

std::string const anna = "Sheet 3/Submissions/Mueller_Anna_uanna_101/";
std::string const bert = "Sheet 3/Submissions/Schulz_Bert_ubert_102/";
}  // namespace

TEST_F(TakeIn, ReadsUserFolders)
{
    Intake const intake = zip({{bert + "exercise_03.cpp", "b", monday}, {anna + "exercise_03.cpp", "a", monday}});
    EXPECT_TRUE(intake.is_ilias);
    EXPECT_EQ(intake.title, "Sheet 3");
    ASSERT_EQ(students(intake), (Names{"Mueller_Anna_uanna_101", "Schulz_Bert_ubert_102"}));
    Upload const& upload = intake.uploads[0];
    EXPECT_EQ(upload.lastname, "Mueller");
    EXPECT_EQ(upload.firstname, "Anna");
    EXPECT_EQ(upload.login, "uanna");
    EXPECT_EQ(upload.usr_id, "101");
    EXPECT_EQ(upload.team, "");
    EXPECT_EQ(bytes_of(upload.file), "a");
    EXPECT_EQ(upload.file.filename(), "exercise_03.cpp");
    EXPECT_EQ(upload.submitted, monday);
    EXPECT_FALSE(upload.late);
    EXPECT_TRUE(has_remark(intake, "no .xlsx"));
}

TEST_F(TakeIn, ReadsAnyWordForTheFolderOfAllSubmissions)
{
    for (char const* word : {"Abgaben", "Rendus", "提出"}) {
        Intake const intake = zip({{std::string("Blatt_3_WS_2016/") + word + "/A_B_c_1/exercise_03.cpp", "a"}});
        EXPECT_EQ(intake.title, "Blatt_3_WS_2016");
        EXPECT_EQ(students(intake), Names{"A_B_c_1"});
    }
}

TEST_F(TakeIn, IsNotFooledByATitleLikeAUser)
{
    Intake const intake =
        zip({{"a_b_c_1/", ""}, {"a_b_c_1/a_b_c_1.xlsx", "?"}, {"a_b_c_1/Submissions/A_B_c_2/exercise_03.cpp", "a"}});
    EXPECT_EQ(students(intake), Names{"A_B_c_2"});
    EXPECT_FALSE(has_remark(intake, "has handed in no"));
}

TEST_F(TakeIn, IsNotFooledByATitleLikeAUserWithoutATable)
{
    Intake const intake = zip({{"x_y_z_9/a_b_c_1/Submissions/A_B_c_2/exercise_03.cpp", "a"},
                               {"x_y_z_9/a_b_c_1/Submissions/D_E_f_3/exercise_03.cpp", "b"}});
    EXPECT_EQ(students(intake), (Names{"A_B_c_2", "D_E_f_3"}));
    EXPECT_EQ(intake.title, "a_b_c_1");
}

TEST_F(TakeIn, LetsNobodyPassForAnother)
{
    Intake const intake = zip({{anna + "exercise_03.cpp", "a", monday},
                               {bert + "Mueller_Anna_uanna_101/exercise_03.cpp", "evil", monday + day},
                               {bert + "Schulz_Bert_ubert_102.xlsx", "evil"}});
    ASSERT_EQ(students(intake), (Names{"Mueller_Anna_uanna_101", "Schulz_Bert_ubert_102"}));
    EXPECT_EQ(bytes_of(intake.uploads[0].file), "a");
    EXPECT_TRUE(intake.uploads[0].older.empty());
    EXPECT_EQ(intake.uploads[1].usr_id, "102");
}

TEST_F(TakeIn, LetsASingleStudentPassForNobody)
{
    Intake const intake =
        zip({{"Sheet 3/Sheet 3.xlsx", "?"}, {bert + "x/Mueller_Anna_uanna_101/exercise_03.cpp", "evil"}});
    EXPECT_EQ(students(intake), (Names{"Schulz_Bert_ubert_102"}));
}

TEST_F(TakeIn, DoesNotGuessWhichUnderscoreSeparates)
{
    Intake const intake = zip({{"S/Abgaben/M_ller_J_rg_uab_7/exercise_03.cpp", "a"}});
    EXPECT_EQ(intake.uploads.at(0).usr_id, "7");
    EXPECT_EQ(intake.uploads.at(0).login, "");
    EXPECT_EQ(intake.uploads.at(0).lastname, "");
}

TEST_F(TakeIn, ReadsAFolderInThatLayoutFromAnyLevel)
{
    for (char const* below : {"", "Sheet 3", "Sheet 3/Submissions", "Sheet 3/Submissions/"}) {
        Intake const intake = folder({{anna + "exercise_03.cpp", "a"}}, below);
        EXPECT_EQ(students(intake), Names{"Mueller_Anna_uanna_101"}) << below;
        EXPECT_EQ(intake.title, "Sheet 3") << below;
        EXPECT_EQ(bytes_of(intake.uploads.at(0).file), "a");
    }
}

TEST_F(TakeIn, TakesTheNewestByTime)
{
    Intake const intake = zip({{anna + "exercise_03 (2).cpp", "old", monday},
                               {anna + "exercise_03.cpp", "new", monday + day},
                               {anna + "exercise_03 (3).cpp", "older", monday - day}});
    ASSERT_EQ(intake.uploads.size(), 1u);
    EXPECT_EQ(bytes_of(intake.uploads[0].file), "new");
    ASSERT_EQ(intake.uploads[0].older.size(), 2u);
    EXPECT_EQ(bytes_of(intake.uploads[0].older[0]), "old");
    EXPECT_EQ(intake.uploads[0].submitted, monday + day);
}

TEST_F(TakeIn, TakesTheNewestByNumberWhereTimesAreThatOfTheDownload)
{
    Intake const intake = zip({{anna + "exercise_03 (10).cpp", "new", monday},
                               {anna + "exercise_03 (9).cpp", "old", monday + 2},
                               {anna + "exercise_03.cpp", "oldest", monday + 4}});
    EXPECT_EQ(bytes_of(intake.uploads.at(0).file), "new");
    EXPECT_EQ(bytes_of(intake.uploads.at(0).older.at(1)), "oldest");
}

TEST_F(TakeIn, PrefersTheNameOfTheExercise)
{
    Intake const intake = zip({{anna + "main.cpp", "?", monday + day}, {anna + "03.cpp", "a", monday}});
    EXPECT_EQ(bytes_of(intake.uploads.at(0).file), "a");
    EXPECT_EQ(intake.uploads.at(0).older.size(), 1u);
}

TEST_F(TakeIn, SeesMarksOfLateFiles)
{
    Intake const intake = zip({{anna + "exercise_03.cpp", "early", monday},
                               {anna + "Verspätet - exercise_03.cpp", "late", monday + day},
                               {bert + "exercise_03 - my final.cpp", "b", monday}});
    EXPECT_TRUE(intake.uploads.at(0).late);
    EXPECT_EQ(bytes_of(intake.uploads[0].file), "late");
    EXPECT_FALSE(intake.uploads.at(1).late);
}

TEST_F(TakeIn, KnowsWhoIsAfterTheDeadline)
{
    std::vector<ZipItem> const items = {{anna + "exercise_03.cpp", "a", monday},
                                        {bert + "exercise_03.cpp", "b", monday + 2}};
    Intake const intake = zip(items, monday);
    EXPECT_FALSE(intake.uploads.at(0).late);
    EXPECT_TRUE(intake.uploads.at(1).late);
}

TEST_F(TakeIn, JoinsTheTable)
{
    Intake const intake = zip({{"Sheet 3/Sheet 3.xlsx", xlsx({{"Last name", "First name", "Login", "Submission"},
                                                              {"Müller", "Änna", "uanna", "46350.5"},
                                                              {"Schulz", "Eva", "ueva", "46350.5"}})},
                               {anna + "exercise_03.cpp", "a", monday},
                               {bert + "exercise_03.cpp", "b", monday}},
                              parse_iso_time("2026-11-24T11:59"));
    Upload const& first = intake.uploads.at(0);
    EXPECT_FALSE(has_remark(intake, "cannot be read"));
    EXPECT_EQ(first.lastname, "Müller");
    EXPECT_EQ(first.submitted, parse_iso_time("2026-11-24T12:00"));
    EXPECT_TRUE(first.late);
    EXPECT_EQ(intake.uploads.at(1).submitted, monday);
    EXPECT_TRUE(has_remark(intake, "'Schulz_Bert_ubert_102' is not in"));
    EXPECT_TRUE(has_remark(intake, "Eva Schulz (ueva) is in"));
}

TEST_F(TakeIn, DoesWithoutADamagedTable)
{
    for (std::string const& bytes : {std::string("damaged"), raw_zip({{"xl/worksheets/sheet1.xml", "<worksheet"}})}) {
        Intake const intake = zip({{"Sheet 3/Sheet 3.xlsx", bytes}, {anna + "exercise_03.cpp", "a", monday}});
        EXPECT_EQ(intake.uploads.at(0).submitted, monday);
        EXPECT_TRUE(has_remark(intake, "'Sheet 3/Sheet 3.xlsx' cannot be read"));
    }
}

TEST_F(TakeIn, ReadsTeams)
{
    std::string const team = "Sheet 3/Abgaben/Team 17/";
    Intake const intake = zip({{team + "A_B_c_1/exercise_03.cpp", "old", monday},
                               {team + "D_E_f_2/exercise_03.cpp", "new", monday + day},
                               {team + "G_H_i_3/", ""},
                               {"Sheet 3/Abgaben/Team 18/J_K_l_4/", ""}});
    EXPECT_EQ(intake.title, "Sheet 3");
    ASSERT_EQ(intake.uploads.size(), 1u);
    Upload const& upload = intake.uploads[0];
    EXPECT_EQ(upload.student, "D_E_f_2");
    EXPECT_EQ(upload.team, "17");
    EXPECT_EQ(upload.usr_id, "2");
    EXPECT_EQ(upload.members, (Names{"A_B_c_1", "D_E_f_2", "G_H_i_3"}));
    EXPECT_EQ(bytes_of(upload.file), "new");
    EXPECT_EQ(bytes_of(upload.older.at(0)), "old");
    EXPECT_TRUE(has_remark(intake, "'team 18' has handed in no"));
}

TEST_F(TakeIn, KnowsTheLoginsOfATeam)
{
    std::string const team = "S/Abgaben/Team 17/";
    Intake const intake = zip(
        {{"S/S.xlsx", xlsx({{"Last name", "First name", "Login"}, {"A", "B", "c"}, {"D", "E", "f"}, {"M", "N", "o"}})},
         {team + "A_B_c_1/exercise_03.cpp", "a", monday},
         {team + "D_E_f_2/", ""},
         {"S/Abgaben/M_N_o_3/exercise_03.cpp", "b", monday}});
    ASSERT_EQ(students(intake), (Names{"A_B_c_1", "M_N_o_3"}));
    EXPECT_EQ(intake.uploads[0].logins, (Names{"c", "f"}));
    EXPECT_EQ(intake.uploads[1].logins, Names{});
}

TEST_F(TakeIn, NamesFoldersSafelyAndStillKnowsTheirNames)
{
    Intake const intake = zip({{"S/Abgaben/-A_B_c_1/exercise_03.cpp", "a"}});
    EXPECT_EQ(intake.uploads.at(0).student, "_-A_B_c_1");
    EXPECT_EQ(intake.uploads.at(0).folder, "-A_B_c_1");
}

TEST_F(TakeIn, ListsStudentsWithoutAFile)
{
    Intake const intake = zip({{anna, ""}, {bert + "notes.txt", "x"}, {bert + "all.ZIP", "x"}});
    EXPECT_TRUE(intake.uploads.empty());
    EXPECT_TRUE(has_remark(intake, "'Mueller_Anna_uanna_101' has handed in no"));
    EXPECT_TRUE(has_remark(intake, "'Schulz_Bert_ubert_102' has handed in no"));
    EXPECT_TRUE(has_remark(intake, "notes.txt' is not a .cpp file"));
    EXPECT_TRUE(has_remark(intake, "all.ZIP' is an archive"));
}

TEST_F(TakeIn, ListsFilesOutsideUserFolders)
{
    Intake const intake = zip({{anna + "exercise_03.cpp", "a"}, {"Sheet 3/stray.cpp", "x"}});
    EXPECT_EQ(intake.uploads.size(), 1u);
    EXPECT_TRUE(has_remark(intake, "'Sheet 3/stray.cpp' lies in no student's folder"));
}

TEST_F(TakeIn, PassesOverWhatSystemsLeaveBehind)
{
    Intake const intake = zip({{anna + "exercise_03.cpp", "a"},
                               {anna + ".DS_Store", "x"},
                               {anna + "._exercise_03.cpp", "x"},
                               {"__MACOSX/" + anna + "._exercise_03.cpp", "x"}});
    EXPECT_EQ(intake.uploads.size(), 1u);
    EXPECT_TRUE(intake.uploads.at(0).older.empty());
    EXPECT_EQ(intake.remarks.size(), 1u);  // no .xlsx
}

TEST_F(TakeIn, GoesOnWithoutEntriesThatAreRefused)
{
    write_file(root_.path() / "hostile.zip", raw_zip({{"../../evil.cpp"}, {anna + "exercise_03.cpp"}}));
    Intake const intake = take_in(root_.path() / "hostile.zip", scratch_, {});
    EXPECT_EQ(intake.uploads.size(), 1u);
    EXPECT_TRUE(has_remark(intake, "'../../evil.cpp'"));
}

TEST_F(TakeIn, ReadsFlatFolders)
{
    Intake const intake =
        folder({{"müller.cpp", "a"}, {"o'neil (2).cpp", "b"}, {"notes.txt", "x"}, {"ubert/03.cpp", "c"}});
    EXPECT_FALSE(intake.is_ilias);
    EXPECT_EQ(intake.title, "unpacked");
    ASSERT_EQ(students(intake), (Names{"müller", "o'neil (2)", "ubert"}));
    EXPECT_EQ(bytes_of(intake.uploads[2].file), "c");
    EXPECT_TRUE(intake.uploads[0].submitted);
    EXPECT_TRUE(has_remark(intake, "notes.txt"));
}

TEST_F(TakeIn, LooksIntoAFolderAroundEverything)
{
    EXPECT_EQ(students(zip({{"all/", ""}, {"all/a.cpp", "a"}, {"all/b.cpp", "b"}})), (Names{"a", "b"}));
    EXPECT_EQ(students(zip({{"all/a/x.cpp", "a"}, {"all/b/x.cpp", "b"}})), (Names{"a", "b"}));
    EXPECT_EQ(students(zip({{"anna/exercise_03.cpp", "a"}, {"anna/exercise_03 (2).cpp", "b"}})), (Names{"anna"}));
}

TEST_F(TakeIn, GivesEachStudentANameOfHisOwn)
{
    Intake const intake = zip({{"a.cpp", "1"}, {"A.CPP", "2"}, {"a/exercise_03.cpp", "3"}, {"b:c.cpp", "4"}});
    EXPECT_EQ(students(intake), (Names{"A", "a (2)", "a (3)", "b_c"}));
}

TEST_F(TakeIn, SaysWhatItCannotRead)
{
    write_file(root_.path() / "exercise_03.cpp", "int main() {}");
    fs::create_directory(root_.path() / "empty");
    for (char const* name : {"missing.zip", "exercise_03.cpp", "empty"}) {
        fs::remove_all(scratch_);
        try {
            take_in(root_.path() / name, scratch_, {});
            ADD_FAILURE() << name;
        } catch (std::invalid_argument const& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
    }
}

TEST_F(TakeIn, DoesNotWaitForWhatIsNoFile)
{
    ASSERT_EQ(mkfifo((root_.path() / "pipe").c_str(), 0600), 0);
    EXPECT_THROW(take_in(root_.path() / "pipe", scratch_, {}), std::invalid_argument);
}

TEST_F(TakeIn, SaysWhyNothingIsLeftOfAHostileZip)
{
    write_file(root_.path() / "hostile.zip", raw_zip({{"../evil.cpp"}}));
    EXPECT_THROW(take_in(root_.path() / "hostile.zip", scratch_, {}), std::invalid_argument);
    EXPECT_FALSE(fs::exists(root_.path() / "evil.cpp"));
}
}  // namespace testat
