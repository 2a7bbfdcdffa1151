#include "report/report.h"

#include "example_grading.h"
#include "grey_picture.h"
#include "installation.h"
#include "json_schema.h"
#include "process/run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat {
namespace {
TestSet const test_set{"1", std::string(64, 'a'), 7};
Submission const submission{"exercise_03.cpp", "int x;", std::string(64, '0'), {}};

std::filesystem::path schema()
{
    return installation().rubric.parent_path() / "report.schema.json";
}

Report report_of(CheckResults const& results, Build const& build, ReportOptions const& options = {})
{
    Rubric const rubric = example_rubric();
    return make_report(submission, build, results, score(results, build, rubric, false), rubric, test_set, {1, 2, 3, 4},
                       options);
}

CheckResults failed_results()
{
    CheckResults results = passed_results(example_rubric());
    CheckResult& failed = find_result(results, "WrapClamp.Negative");
    failed.passed = false;
    failed.detail = "expected 5";
    failed.mismatch = Mismatch{"val = -1, size = 6", "-1", "5"};
    return results;
}

/// One pixel is not finite.
CheckResults results_with_nan()
{
    CheckResults results = passed_results(example_rubric());
    PictureResult& picture = results.pictures[0];
    IsolatedPicture& isolated = picture.isolated[0];
    isolated.rendering->picture->rgb[0] = NAN;
    isolated.rendering->comparison = {1, 0, 0.5, HUGE_VAL, HUGE_VAL};
    isolated.score = 0.5;
    return results;
}

/// Whether the schema takes it.
bool is_valid(Report const& report)
{
    try {
        validate_json(nlohmann::json::parse(to_text(report)), schema(), "report");
        return true;
    } catch (BadJson const&) {
        return false;
    }
}

bool mentions(Report const& report, std::string const& text)
{
    return to_text(report).find(text) != std::string::npos;
}
}  // namespace

TEST(MakeReport, KeepsItsSchema)
{
    EXPECT_TRUE(is_valid(report_of(passed_results(example_rubric()), whole_build())));
    EXPECT_TRUE(is_valid(report_of(failed_results(), whole_build())));
    EXPECT_TRUE(is_valid(report_of(CheckResults{}, Build{})));
    EXPECT_TRUE(is_valid(make_not_gradable(submission, test_set, "the disk is full")));
}

TEST(MakeReport, KeepsItsSchemaForAFileTooLargeToHash)
{
    Submission const large{"exercise_03.cpp", "", "", "the file is larger than 1 MB"};
    EXPECT_TRUE(is_valid(make_not_gradable(large, test_set, "")));
    EXPECT_TRUE(is_valid(make_report(large, Build{}, {}, Grade{}, Rubric{}, test_set, {}, {}))) << "graded";
}

TEST(MakeReport, WritesNullForWhatIsNotFinite)
{
    Report const report = report_of(results_with_nan(), whole_build());
    EXPECT_TRUE(report["pictures"][0]["rms"].is_null());
    EXPECT_TRUE(report["pictures"][0]["max_error"].is_null());
    EXPECT_TRUE(is_valid(report));
    EXPECT_FALSE(mentions(report, "nan"));
    EXPECT_FALSE(mentions(report, "inf"));
}

TEST(ReportSchema, RefusesNaNAsText)
{
    Report report = report_of(passed_results(example_rubric()), whole_build());
    report["pictures"][0]["rms"] = "NaN";
    EXPECT_FALSE(is_valid(report));
}

TEST(ReportSchema, RefusesWhatTheContractDoesNotKnow)
{
    Report const right = report_of(passed_results(example_rubric()), whole_build());
    for (char const* key : {"points", "functions", "test_set", "timing"}) {
        Report wrong = right;
        wrong.erase(key);
        EXPECT_FALSE(is_valid(wrong)) << key;
    }
    Report wrong = right;
    wrong["status"] = "perfect";
    EXPECT_FALSE(is_valid(wrong));
    wrong = right;
    wrong["functions"]["wrap_clamp"]["verdict"] = "nice";
    EXPECT_FALSE(is_valid(wrong));
}

TEST(MakeReport, HoldsPointsByFunctionAndTask)
{
    Report const report = report_of(failed_results(), whole_build());
    EXPECT_EQ(report["points"]["earned"], 1.25);
    EXPECT_EQ(report["points"]["max"], 2);
    EXPECT_EQ(report["functions"]["wrap_clamp"]["earned"], 0.25);
    EXPECT_EQ(report["functions"]["wrap_clamp"]["verdict"], "partial");
    EXPECT_EQ(report["tasks"][0]["earned"], 1.25);
    EXPECT_EQ(report["tasks"][0]["title"]["de"], "Umgang mit Rändern");
}

TEST(MakeReport, SaysWhatAFailedCheckWasAskedAndGave)
{
    Report const checks = report_of(failed_results(), whole_build())["functions"]["wrap_clamp"]["checks"];
    EXPECT_EQ(checks[1]["passed"], false);
    EXPECT_EQ(checks[1]["worst_input"]["input"], "val = -1, size = 6");
    EXPECT_EQ(checks[1]["worst_input"]["measured"], "-1");
    EXPECT_EQ(checks[1]["hint"]["en"], "hint for WrapClamp.Negative");
    EXPECT_TRUE(checks[0]["hint"].is_null()) << "passed";
}

TEST(MakeReport, TellsOnlyTutorsWhatWasExpected)
{
    EXPECT_TRUE(mentions(report_of(failed_results(), whole_build(), {true}), "expected 5"));
    EXPECT_FALSE(mentions(report_of(failed_results(), whole_build(), {false}), "expected 5"));
}

TEST(MakeReport, TellsHowAFunctionEndedInsteadOfTheHint)
{
    CheckResults results = failed_results();
    CheckResult& crashed = find_result(results, "WrapClamp.Negative");
    crashed.ended = Ended::signal;
    crashed.trouble = Phrase{"Absturz", "Crash"};
    Report const report = report_of(results, whole_build());
    EXPECT_EQ(report["functions"]["wrap_clamp"]["checks"][1]["hint"]["de"], "Absturz");
    EXPECT_EQ(report["functions"]["wrap_clamp"]["verdict"], "crashed");
}

TEST(MakeReport, TellsOfPrintingBesideTheHint)
{
    CheckResults results = failed_results();
    find_result(results, "WrapClamp.Negative").trouble = Phrase{"Gibt aus.", "Prints."};
    find_result(results, "WrapClamp.Inside").trouble = Phrase{"Gibt aus.", "Prints."};
    Report const checks = report_of(results, whole_build())["functions"]["wrap_clamp"]["checks"];
    EXPECT_EQ(checks[0]["hint"]["en"], "Prints.");
    EXPECT_EQ(checks[1]["hint"]["en"], "hint for WrapClamp.Negative Prints.");
}

TEST(MakeReport, HoldsPolicyAndDiagnostics)
{
    Build build = whole_build();
    build.ok = false;
    build.diagnostics = {{"exercise_03.cpp", 3, 1, "error", "broken"}};
    Report const report = report_of(passed_results(example_rubric()), build);
    EXPECT_EQ(report["points"]["earned"], 0);
    EXPECT_EQ(report["policy"]["applied"][0], "does_not_compile");
    EXPECT_EQ(report["policy"]["earned_without"], 2);
    EXPECT_EQ(report["build"]["diagnostics"][0]["line"], 3);
    EXPECT_TRUE(is_valid(report));
}

TEST(MakeReport, HoldsUnofficialPoints)
{
    Build const build = mended_build();
    Report const report = report_of(passed_results(example_rubric()), build);
    EXPECT_EQ(report["points"]["earned"], 0);
    EXPECT_EQ(report["policy"]["earned_without"], 0);
    EXPECT_EQ(report["functions"]["wrap_repeat"]["earned"], 0);
    Report const& unofficial = report["unofficial"];
    EXPECT_EQ(unofficial["earned"], 1);
    EXPECT_EQ(unofficial["max"], 1);
    EXPECT_EQ(unofficial["functions"].size(), 1u);
    EXPECT_EQ(unofficial["functions"]["wrap_repeat"]["verdict"], "correct");
    EXPECT_EQ(unofficial["broken"]["wrap_clamp"]["line"], 3);
    EXPECT_EQ(unofficial["broken"]["wrap_clamp"]["message"], "'x' was not declared");
    EXPECT_TRUE(is_valid(report));
}

TEST(MakeReport, HoldsWhatElseDoesNotCompile)
{
    Build build = mended_build();
    build.broken.clear();
    build.left_out = {{"exercise_03.cpp", 2, 1, "error", "'junk' is no type"}};
    Report const report = report_of(passed_results(example_rubric()), build);
    EXPECT_EQ(report["points"]["earned"], 0);
    EXPECT_EQ(report["unofficial"]["earned"], 2);
    EXPECT_EQ(report["unofficial"]["left_out"][0]["line"], 2);
    EXPECT_TRUE(is_valid(report));
}

TEST(MakeReport, HasNoUnofficialPointsOtherwise)
{
    EXPECT_FALSE(report_of(passed_results(example_rubric()), whole_build()).contains("unofficial"));
    EXPECT_FALSE(report_of(CheckResults{}, Build{}).contains("unofficial"));
}

TEST(MakeReport, ShowsTheSource)
{
    Build build = whole_build();
    build.sources[Function::wrap_clamp] = {12, "int wrap_clamp() {}"};
    Report const report = report_of(passed_results(example_rubric()), build);
    EXPECT_EQ(report["functions"]["wrap_clamp"]["source"]["line"], 12);
    EXPECT_TRUE(report["functions"]["wrap_repeat"]["source"].is_null());
}

TEST(MakeReport, HoldsRemarksOnlyIfThereAreAny)
{
    CheckResults results = passed_results(example_rubric());
    EXPECT_FALSE(report_of(results, whole_build()).contains("remarks"));
    results.remarks = {{"leaks", {Function::wrap_clamp}, {"Wächst.", "Grows."}}, {"races", {}, {"de", "en"}}};
    Report const report = report_of(results, whole_build());
    EXPECT_EQ(report["remarks"][0]["id"], "leaks");
    EXPECT_EQ(report["remarks"][0]["functions"], Report::array({"wrap_clamp"}));
    EXPECT_EQ(report["remarks"][0]["de"], "Wächst.");
    EXPECT_TRUE(report["remarks"][1]["functions"].empty());
    EXPECT_EQ(report["points"]["earned"], 2) << "they change no points";
    EXPECT_TRUE(is_valid(report));
}

TEST(ReportSchema, RefusesUnknownRemarks)
{
    CheckResults results = passed_results(example_rubric());
    results.remarks = {{"smells", {}, {"de", "en"}}};
    EXPECT_FALSE(is_valid(report_of(results, whole_build())));
}

TEST(MakeReport, SurvivesTextThatIsNotUtf8)
{
    Build build = whole_build();
    build.compiler = "g++ \xff";
    EXPECT_TRUE(mentions(report_of(passed_results(example_rubric()), build), "g++ \xef\xbf\xbd"));
}

TEST(MakeNotGradable, HasNoPoints)
{
    Report const report = make_not_gradable(submission, test_set, "the disk is full");
    EXPECT_EQ(report["status"], "not_gradable");
    EXPECT_EQ(report["error"], "the disk is full");
    EXPECT_FALSE(report.contains("points"));
}

TEST(ReadReport, GivesBackWhatWasWritten)
{
    TemporaryDirectory const directory;
    Report const report = report_of(failed_results(), whole_build());
    write_atomically(directory.path() / "report.json", to_text(report));
    EXPECT_EQ(to_text(read_report(directory.path() / "report.json", schema())), to_text(report));
}

TEST(ReadReport, RefusesAnotherDocument)
{
    TemporaryDirectory const directory;
    write_file(directory.path() / "report.json", "{}");
    EXPECT_THROW(read_report(directory.path() / "report.json", schema()), BadJson);
    EXPECT_THROW(read_report(directory.path() / "nothing.json", schema()), BadJson);
}
}  // namespace testat
