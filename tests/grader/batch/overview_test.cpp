#include "batch/overview.h"

#include "example_grading.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Report example_report()
{
    Rubric const rubric = example_rubric();
    CheckResults results = passed_results(rubric);
    find_result(results, "WrapClamp.Negative").passed = false;
    Build const build = whole_build();
    Report report = make_report({}, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, {}, {});
    report["functions"]["wrap_clamp"]["mistake"] = {{"id", "clamp_wraps"}, {"de", "ein Fehler"}, {"en", "a mistake"}};
    return report;
}

GradedUpload entry_of(std::string const& student, Report const& report)
{
    GradedUpload entry;
    entry.upload.student = student;
    entry.report = report;
    return entry;
}

std::string page_of(std::vector<GradedUpload> const& entries, std::vector<SimilarPair> const& similar = {})
{
    return overview_page(entries, similar, "Übung 3", Language::en);
}

bool contains(std::string const& text, std::string const& part)
{
    return text.find(part) != std::string::npos;
}
}  // namespace

TEST(Overview, LinksEachReport)
{
    std::string const page = page_of({entry_of("Müller_A b", example_report())});
    EXPECT_TRUE(contains(page, "<a href=\"reports/M%C3%BCller_A%20b/report.html\">Müller_A b</a>")) << page;
}

TEST(Overview, MarksWhoIsLateSimilarOverriddenOrNotGradable)
{
    GradedUpload late = entry_of("late", example_report());
    late.upload.late = true;
    GradedUpload changed = entry_of("changed", example_report());
    changed.report["functions"]["wrap_clamp"]["override"] = {{"reason", "r"}};
    GradedUpload const failed = entry_of("failed", make_not_gradable({}, {"1", "", 1}, "no disk"));
    std::string const page =
        page_of({late, changed, failed, entry_of("alike", example_report())}, {{"alike", "of_last_year", 90, ""}});
    for (char const* state : {"\"late passed\"", "\"passed overridden\"", "\"ungradable\"", "\"similar passed\""})
        EXPECT_TRUE(contains(page, std::string("data-state=") + state)) << state;
    EXPECT_TRUE(contains(page, "no disk"));
}

TEST(Overview, GroupsTheSameMistake)
{
    std::string const page = page_of({entry_of("anna", example_report()), entry_of("bert", example_report())});
    EXPECT_TRUE(contains(page, "<b>2</b> <code>clamp_wraps</code>"));
    EXPECT_TRUE(contains(page, "a mistake"));
}

TEST(Overview, TakesNamesAsText)
{
    std::string const attack = "\"><script>alert(1)</script>";
    GradedUpload entry = entry_of(attack, example_report());
    entry.upload.lastname = entry.upload.login = entry.upload.team = attack;
    entry.report["functions"]["wrap_clamp"]["mistake"] = {{"id", attack}, {"de", attack}, {"en", attack}};
    std::string const page =
        overview_page({entry, entry_of(attack, make_not_gradable({}, {"1", "", 1}, attack))}, {}, attack, Language::en);
    EXPECT_EQ(page.find("<script"), page.rfind("<script"));
    EXPECT_TRUE(contains(page, "&lt;script&gt;alert(1)"));
}

TEST(Overview, TakesABatchInWhichNothingCouldBeGraded)
{
    EXPECT_TRUE(contains(page_of({entry_of("a", make_not_gradable({}, {"1", "", 1}, "x"))}), "<b>0</b>"));
    EXPECT_TRUE(contains(page_of({}), "<tbody>"));
}
}  // namespace testat
