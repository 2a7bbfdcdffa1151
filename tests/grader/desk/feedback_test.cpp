// From a made-up download to what ILIAS takes back; and that the check of that rejects what ILIAS would not take.
#include "batch/intake.h"
#include "batch/times.h"
#include "batch/zips.h"
#include "end_to_end/testat_program.h"
#include "installation.h"
#include "rubric/rubric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace testat {
namespace {
namespace fs = std::filesystem;
using Rows = std::vector<std::vector<std::string>>;

Finished run_program(std::vector<std::string> const& arguments)
{
    Command command;
    command.argv = arguments;
    command.wall_s = 60;
    return run(command);
}

Finished make_export(fs::path const& file, std::vector<std::string> const& more)
{
    std::vector<std::string> arguments{TESTAT_MAKE_EXPORT, file.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
}

Finished check_feedback(fs::path const& download, fs::path const& folder)
{
    return run_program({TESTAT_CHECK_FEEDBACK, download.string(), folder.string(), "--assignment", "77"});
}

/// What a batch would write for a student, a team, and a student who could not be graded.
struct Outputs {
    std::vector<ZipItem> feedback{{"multi_feedback_S_1_77/A_B_c_1/testat.txt", "a"},
                                  {"multi_feedback_S_1_77/D_E_f_2/testat.txt", "d"},
                                  {"multi_feedback_S_1_77/G_H_i_3/testat.html", "<p style='color:red'>"}};
    Rows students{{"update", "usr_id", "login", "lastname", "firstname", "status", "mark", "notice", "comment",
                   "plagiarism", "plag_comment"},
                  {"1", "1", "c", "A", "B", "passed", "18.50", "late", "18.50 of 20.00 points", "", ""},
                  {"0", "4", "l", "J", "K", "notgraded", "", "no disk", "", "", ""}};
    Rows teams{{"update", "team_id", "logins", "status", "mark", "notice", "comment", "plagiarism", "plag_comment"},
               {"1", "7", "f, i", "failed", "3.00", "", "3.00 of 20.00 points", "", ""}};
};

using Spoil = std::function<void(Outputs&)>;

/// The check of a small download after something has been done to the outputs.
Finished check_after(Spoil const& spoil)
{
    TemporaryDirectory const place;
    Outputs outputs;
    spoil(outputs);
    fs::path const table = place.path() / "table.xlsx", download = place.path() / "download.zip";
    write_xlsx(
        table,
        {{"Nachname", "Vorname", "Benutzername"}, {"A", "B", "c"}, {"D", "E", "f"}, {"G", "H", "i"}, {"J", "K", "l"}});
    write_zip(download, {{"S 1/S 1.xlsx", bytes_of(table)},
                         {"S 1/Abgaben/A_B_c_1/exercise_03.cpp", "a"},
                         {"S 1/Abgaben/Team 7/D_E_f_2/exercise_03.cpp", "d"},
                         {"S 1/Abgaben/Team 7/G_H_i_3/", ""},
                         {"S 1/Abgaben/J_K_l_4/exercise_03.cpp", "j"}});
    write_file(place.path() / "grades.csv",
               "name,usr_id,team,status,earned,passed_60_percent\r\nA_B_c_1,1,,graded,18.5,1\r\n"
               "D_E_f_2,2,7,graded,3,0\r\n\"J_K_l_4\",4,,not_gradable,,\r\n");
    write_zip(place.path() / "feedback.zip", outputs.feedback);
    write_xlsx(place.path() / "status.xlsx", outputs.students);
    write_xlsx(place.path() / "status_teams.xlsx", outputs.teams);
    return check_feedback(download, place.path());
}

void expect_rejected(std::map<std::string, Spoil> const& spoilings)
{
    for (auto const& [complaint, spoil] : spoilings) {
        Finished const finished = check_after(spoil);
        EXPECT_EQ(finished.exit_code, 1) << complaint;
        EXPECT_NE(finished.output.find(complaint), std::string::npos) << complaint << "\n" << finished.output;
    }
}

/// The first student's feedback has another name.
Spoil name(std::string const& other)
{
    return [other](Outputs& o) { o.feedback[0].name = other; };
}

/// A cell of the first student or team is another one.
Spoil cell(Rows Outputs::*sheet, std::size_t column, std::string const& other)
{
    return [=](Outputs& o) { (o.*sheet)[1][column] = other; };
}
}  // namespace

TEST(FeedbackCheck, AcceptsWhatIsRight)
{
    Finished const finished = check_after([](Outputs&) {});
    EXPECT_EQ(finished.exit_code, 0) << finished.output;
}

TEST(FeedbackCheck, RejectsASpoiledZip)
{
    std::string const top = "multi_feedback_S_1_77/";
    expect_rejected({
        {"has 2 parts", name(top + "testat.txt")},
        {"has 4 parts", name(top + "A_B_c_1/x/testat.txt")},
        {"is for nobody", name(top + "A_B_1/testat.txt")},
        {"is hidden", name(top + "A_B_c_1/.testat.txt")},
        {"has a backslash", name(top + "A_B_c_1\\testat.txt")},
        {"A_B_c_1/exercise_03.cpp' is named like", name(top + "A_B_c_1/exercise_03.cpp")},
        {"2 folders at the top", name("multi_feedback_S_1_78/A_B_c_1/testat.txt")},
        {"'multi_feedback_S 1_77' instead of", name("multi_feedback_S 1_77/A_B_c_1/testat.txt")},
        {"A_B_c_1 is graded, but has no", [](Outputs& o) { o.feedback.erase(o.feedback.begin()); }},
        {"G_H_i_3 is graded, but has no", [](Outputs& o) { o.feedback.pop_back(); }},
        {"J_K_l_4 is not graded",
         [&](Outputs& o) {
             o.feedback.push_back({top + "J_K_l_4/testat.txt", "j"});
         }},
        {"more than one",
         [&](Outputs& o) {
             o.feedback.push_back({top + "A_B_c_1/more.txt", "m"});
         }},
        {"is no file",
         [&](Outputs& o) {
             o.feedback.push_back({top + "A_B_c_1/", ""});
         }},
        {"is empty", [](Outputs& o) { o.feedback[0].bytes = ""; }},
        {"needs other files", [](Outputs& o) { o.feedback[2].bytes = "<img src='picture.png'>"; }},
    });
}

TEST(FeedbackCheck, RejectsASpoiledStatusSheet)
{
    expect_rejected({
        {"user 1: update is '0'", cell(&Outputs::students, 0, "0")},
        {"user 5 has a status", cell(&Outputs::students, 1, "5")},
        {"user 1: login and names", cell(&Outputs::students, 2, "x")},
        {"user 1: the status is 'failed'", cell(&Outputs::students, 5, "failed")},
        {"user 1: the mark is '18.25'", cell(&Outputs::students, 6, "18.25")},
        {"user 1: the mark is ''", cell(&Outputs::students, 6, "")},
        {"team 7: the logins are 'f'", cell(&Outputs::teams, 2, "f")},
        {"team 7: the status is 'passed'", cell(&Outputs::teams, 3, "passed")},
        {"user 4: update is '1'", [](Outputs& o) { o.students[2][0] = "1"; }},
        {"user 1 has two rows", [](Outputs& o) { o.students.push_back(o.students[1]); }},
        {"user 4 is in grades.csv, but", [](Outputs& o) { o.students.pop_back(); }},
        {"columns are not those of ILIAS", [](Outputs& o) { std::swap(o.students[0][5], o.students[0][6]); }},
    });
}

TEST(MadeUpDownload, IsTheSameForASeed)
{
    TemporaryDirectory const place;
    for (char const* seed : {"5", "6"})
        EXPECT_EQ(make_export(place.path() / seed, {"--uploads", "20", "--seed", seed}).exit_code, 0);
    make_export(place.path() / "again", {"--uploads", "20", "--seed", "5"});
    EXPECT_EQ(bytes_of(place.path() / "again"), bytes_of(place.path() / "5"));
    EXPECT_NE(bytes_of(place.path() / "6"), bytes_of(place.path() / "5"));
}

TEST(MadeUpDownload, HasAllKindsOfUploads)
{
    TemporaryDirectory const place;
    Finished const made = make_export(place.path() / "x.zip", {"--uploads", "300"});
    ASSERT_EQ(made.exit_code, 0) << made.output;
    Intake const intake = take_in(place.path() / "x.zip", place.path() / "scratch",
                                  parse_deadline(read_rubric(installation().rubric).deadline));
    EXPECT_EQ(intake.uploads.size(), 300u);
    std::set<std::string> texts, names;
    for (auto const& upload : intake.uploads) {
        texts.insert(bytes_of(upload.file));
        names.insert(upload.file.filename().string());
        EXPECT_TRUE(upload.submitted && !upload.login.empty() && !upload.lastname.empty()) << upload.student;
    }
    EXPECT_EQ(texts.size(), 210u);
    EXPECT_EQ(texts.count(""), 1u);
    EXPECT_EQ(names, (std::set<std::string>{"03.cpp", "Verspätete Abgabe - exercise_03.cpp", "exercise_03 (2).cpp",
                                            "exercise_03.cpp"}));
    auto const count = [&](auto const& fits) {
        return std::count_if(intake.uploads.begin(), intake.uploads.end(), fits);
    };
    EXPECT_GT(count([](Upload const& u) { return !u.team.empty(); }), 10);
    EXPECT_GT(count([](Upload const& u) { return u.late; }), 10);
    EXPECT_GT(count([](Upload const& u) { return !u.older.empty(); }), 5);
    EXPECT_EQ(intake.remarks.size(), 3u);  // the zip, whose it is, and who has no folder
}

TEST(FeedbackZip, OfABatchIsWhatIliasTakes)
{
    TemporaryDirectory const place;
    fs::path const download = place.path() / "download.zip", out = place.path() / "out";
    Finished const made = make_export(download, {"--uploads", "8"});
    ASSERT_EQ(made.exit_code, 0) << made.output;
    Outcome const graded = run_testat({"batch", download.string(), "--out", out.string(), "--assignment", "77"});
    ASSERT_EQ(graded.exit_code, 0) << graded.err;
    Finished const checked = check_feedback(download, out);
    EXPECT_EQ(checked.exit_code, 0) << checked.output;
    EXPECT_NE(checked.output.find("8 students and teams"), std::string::npos) << checked.output;
    // It is this download's, and no other one's.
    make_export(download, {"--uploads", "8", "--seed", "2"});
    EXPECT_EQ(check_feedback(download, out).exit_code, 1);
}
}  // namespace testat
