// What tutors get of a batch: the table, the summary, and what a regrade would change.
#include "batch/regrade.h"

#include "example_grading.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Report example_report(bool right, std::string const& sha256)
{
    Rubric const rubric = example_rubric();
    CheckResults results = passed_results(rubric);
    find_result(results, "WrapClamp.Negative").passed = right;
    Build const build = whole_build();
    Submission submission;
    submission.file = "exercise_03.cpp";
    submission.sha256 = sha256;
    return make_report(submission, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, {}, {});
}

GradedUpload entry_of(std::string const& student, Report report)
{
    GradedUpload entry;
    entry.upload.student = student;
    entry.key = student + "-key";
    entry.report = std::move(report);
    return entry;
}

bool contains(std::string const& text, std::string const& part)
{
    return text.find(part) != std::string::npos;
}
}  // namespace

TEST(GradesTable, HasARowForEachStudent)
{
    GradedUpload late = entry_of("Müller_Änne_am_12", example_report(true, "a"));
    late.upload.late = true;
    late.upload.login = "am";
    late.upload.submitted = 1795604340;
    std::string const table = grades_table({late, entry_of("bert", make_not_gradable({}, {"1", "", 1}, "no disk"))});
    EXPECT_TRUE(contains(table, "Müller_Änne_am_12,,,am,,,2026-11-25T10:59:00Z,1,")) << table;
    EXPECT_TRUE(contains(table, "not_gradable")) << table;
}

TEST(Summary, CountsAndListsNotGradableApart)
{
    std::vector<GradedUpload> const entries{entry_of("anna", example_report(true, "a")),
                                            entry_of("bert", make_not_gradable({}, {"1", "", 1}, "no disk"))};
    std::string const text = summary(entries, {"carl: no file"}, Language::en);
    EXPECT_TRUE(contains(text, "2 uploads, 1 graded, 1 with 60 % or more")) << text;
    EXPECT_TRUE(contains(text, "bert: no disk")) << text;
    EXPECT_TRUE(contains(text, "carl: no file")) << text;
}

TEST(Summary, IsThereForNobodyToo)
{
    EXPECT_TRUE(contains(summary({}, {}, Language::de), "0 Abgaben"));
}

TEST(Regrade, SaysWhoChangesByHowMuch)
{
    TemporaryDirectory const place;
    auto const file = place.path() / "applied.json";
    Applied(file).remember({entry_of("anna", example_report(true, "a")), entry_of("bert", example_report(true, "b"))});
    std::string const changes = Applied(file).changes(
        {entry_of("anna", example_report(false, "a")), entry_of("bert", example_report(true, "b"))}, place.path(),
        Language::en);
    EXPECT_TRUE(contains(changes, "anna: 2.00 -> 1.25")) << changes;
    EXPECT_FALSE(contains(changes, "bert")) << changes;
}

TEST(Regrade, IsNoneForNewUploads)
{
    TemporaryDirectory const place;
    auto const file = place.path() / "applied.json";
    Applied(file).remember({entry_of("anna", example_report(true, "a"))});
    EXPECT_EQ(Applied(file).changes(
                  {entry_of("anna", example_report(false, "other")), entry_of("new", example_report(false, "a"))},
                  place.path(), Language::en),
              "");
}
}  // namespace testat
