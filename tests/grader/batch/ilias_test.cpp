#include "batch/ilias.h"

#include "batch/archive.h"
#include "batch/table.h"
#include "example_grading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace testat {
namespace {
Report example_report()
{
    Rubric const rubric = example_rubric();
    CheckResults const results = passed_results(rubric);
    Build const build = whole_build();
    return make_report({}, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, {}, {});
}

std::vector<GradedUpload> example_entries()
{
    GradedUpload anna, bert, team;
    anna.upload.student = anna.upload.folder = "Müller_Anna_am_12";
    anna.report = example_report();
    bert.upload.student = bert.upload.folder = "Bert_B_bb_13";
    bert.report = make_not_gradable({}, {"1", "", 1}, "no disk");
    team.upload.student = team.upload.folder = "C_C_cc_14";
    team.upload.team = "3";
    team.upload.logins = {"cc", "dd"};
    team.upload.members = {"C_C_cc_14", "D_D_dd_15"};
    team.report = example_report();
    return {anna, bert, team};
}

/// As a batch has written them.
std::filesystem::path write_pages(std::vector<GradedUpload> const& entries, std::filesystem::path const& place)
{
    for (auto const& entry : entries) {
        std::filesystem::create_directories(place / "reports" / entry.upload.student);
        write_file(place / "reports" / entry.upload.student / "report.html", "<!doctype html>");
    }
    return place / "reports";
}

std::string bytes_of(std::filesystem::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> names_in(std::filesystem::path const& zip)
{
    TemporaryDirectory const place;
    std::vector<std::string> names;
    for (auto const& entry : unpack(zip, place.path() / "unpacked").entries)
        names.push_back(entry.name);
    std::sort(names.begin(), names.end());
    return names;
}
}  // namespace

TEST(FeedbackZip, HasAFileForEveryGradedStudentAndMember)
{
    TemporaryDirectory const place;
    auto const zip = place.path() / "feedback.zip";
    write_feedback_zip(example_entries(), write_pages(example_entries(), place.path()), "Übung 3", "77", zip);
    std::string const top = "multi_feedback_Übung_3_77/";
    EXPECT_EQ(names_in(zip), (std::vector<std::string>{top + "C_C_cc_14/testat.html", top + "D_D_dd_15/testat.html",
                                                       top + "Müller_Anna_am_12/testat.html"}));
}

TEST(FeedbackZip, HasFoldersAsIliasNamesThem)
{
    TemporaryDirectory const place;
    auto const zip = place.path() / "feedback.zip";
    GradedUpload entry = example_entries()[0];
    entry.upload.student = "_-Anna_am_12";  // a folder of ours must not look like an option
    entry.upload.folder = "-Anna_am_12";
    write_feedback_zip({entry}, write_pages({entry}, place.path()), "x", "0", zip);
    EXPECT_EQ(names_in(zip), std::vector<std::string>{"multi_feedback_x_0/-Anna_am_12/testat.html"});
}

TEST(FeedbackZip, IsTheSameTwice)
{
    TemporaryDirectory const place;
    auto const reports = write_pages(example_entries(), place.path());
    for (char const* name : {"a.zip", "b.zip"})
        write_feedback_zip(example_entries(), reports, "x", "0", place.path() / name);
    EXPECT_EQ(bytes_of(place.path() / "a.zip"), bytes_of(place.path() / "b.zip"));
}

TEST(FeedbackZip, SaysThatItCannotBeWritten)
{
    TemporaryDirectory const place;
    auto const reports = write_pages(example_entries(), place.path());
    EXPECT_THROW(write_feedback_zip(example_entries(), reports, "x", "0", "/no/such/folder/a.zip"), std::runtime_error);
    EXPECT_THROW(write_feedback_zip(example_entries(), place.path(), "x", "0", place.path() / "a.zip"),
                 std::runtime_error)
        << "no pages";
}

TEST(StatusSheet, IsTheSameTwiceAndDiffersForTeams)
{
    TemporaryDirectory const place;
    auto const sheet = [&](char const* name, bool teams) {
        write_status_sheet(example_entries(), teams, Language::en, place.path() / name);
        return bytes_of(place.path() / name);
    };
    std::string const students = sheet("a.xlsx", false);
    EXPECT_EQ(students, sheet("b.xlsx", false));
    EXPECT_NE(students, sheet("c.xlsx", true));
}

TEST(StatusSheet, NamesAllOfATeam)
{
    TemporaryDirectory const place;
    auto const file = place.path() / "status.xlsx";
    write_status_sheet(example_entries(), true, Language::en, file);
    Rows const rows = read_xlsx(file, place.path() / "unpacked");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[1].at(1), "3");
    EXPECT_EQ(rows[1].at(2), "cc, dd");
}

TEST(IliasStatus, IsNotGradedForOurFaults)
{
    EXPECT_EQ(ilias_status(example_report()), "passed");
    EXPECT_EQ(ilias_status(make_not_gradable({}, {"1", "", 1}, "no disk")), "notgraded");
}
}  // namespace testat
