#include "report/formats/format.h"

#include "example_grading.h"

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cstring>
#include <set>

namespace testat {
namespace {
constexpr char failed_check[] = "WrapClamp.Negative";

Report report_of(CheckResults const& results, Build const& build)
{
    Rubric const rubric = example_rubric();
    Submission submission;
    submission.file = "exercise_03.cpp";
    return make_report(submission, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, {}, {});
}

Report right_report()
{
    return report_of(passed_results(example_rubric()), whole_build());
}

Report wrong_report()
{
    CheckResults results = passed_results(example_rubric());
    CheckResult& result = find_result(results, failed_check);
    result.passed = false;
    result.mismatch = Mismatch{"val = -1, size = 6", "-1 \x01<\"&", "0"};
    return report_of(results, whole_build());
}

Report not_gradable()
{
    return make_not_gradable({}, {"1", "", 1}, "no compiler");
}

pugi::xml_document parse(std::string const& xml)
{
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(xml.c_str()));
    return document;
}

std::vector<std::string> lines(std::string const& text)
{
    std::vector<std::string> all;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t const end = text.find("\r\n", at);
        all.push_back(text.substr(at, end - at));
        at = end + 2;
    }
    return all;
}
}  // namespace

TEST(Csv, HasARowForEachReportAndAHeader)
{
    auto const rows = lines(to_csv({{"anna", right_report()}, {"bert", not_gradable()}}, Language::en));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].rfind("name,file,sha256,status,earned,max,", 0), 0u);
    EXPECT_EQ(rows[1].rfind("anna,exercise_03.cpp,", 0), 0u);
    EXPECT_NE(rows[2].find(",not_gradable,,,"), std::string::npos);
}

TEST(Csv, HoldsNoFormulasAndQuotesWhatNeedsIt)
{
    auto const rows =
        lines(to_csv({{"=cmd|' /C calc'!A0", right_report()}, {"a,\"b\"", right_report()}}, Language::en));
    EXPECT_EQ(rows.at(1).rfind("'=cmd", 0), 0u);
    EXPECT_EQ(rows.at(2).rfind("\"a,\"\"b\"\"\",", 0), 0u);
}

TEST(Csv, TellsWhichChecksHavePassed)
{
    auto const rows = lines(to_csv({{"anna", wrong_report()}}, Language::en));
    std::size_t const comma = static_cast<std::size_t>(
        std::count(rows[0].begin(), rows[0].begin() + std::ptrdiff_t(rows[0].find(failed_check)), ','));
    std::size_t at = 0;
    for (std::size_t i = 0; i < comma; ++i)
        at = rows[1].find(',', at) + 1;
    EXPECT_EQ(rows[1].substr(at, 1), "0");
}

TEST(Junit, HasOneSuiteWithUniqueNamesAndRightCounts)
{
    auto const document = parse(to_junit({{"anna", wrong_report()}, {"bert", right_report()}}, Language::en));
    auto const suites = document.child("testsuites");
    EXPECT_EQ(std::distance(suites.begin(), suites.end()), 1);
    std::set<std::string> names;
    int tests = 0, failures = 0;
    for (auto const& test : suites.child("testsuite").children("testcase")) {
        ++tests;
        failures += test.child("failure") ? 1 : 0;
        names.insert(test.attribute("name").value());
    }
    EXPECT_EQ(names.size(), std::size_t(tests));
    EXPECT_EQ(suites.attribute("tests").as_int(), tests);
    EXPECT_EQ(suites.attribute("failures").as_int(), failures);
    EXPECT_EQ(failures, 1);
}

TEST(Junit, SaysItInMessageAndBody)
{
    auto const document = parse(to_junit({{"anna", wrong_report()}}, Language::en));
    auto const test = document.child("testsuites").child("testsuite").find_child_by_attribute("name", failed_check);
    ASSERT_TRUE(test);
    EXPECT_NE(std::strlen(test.child("failure").attribute("message").value()), 0u);
    EXPECT_NE(std::string(test.child("failure").text().get()).find("val = -1"), std::string::npos);
}

TEST(Junit, CallsOurFaultAnError)
{
    auto const document = parse(to_junit({{"anna", not_gradable()}}, Language::en));
    EXPECT_EQ(document.child("testsuites").attribute("errors").as_int(), 1);
}

TEST(Gradescope, AddsUpToThePoints)
{
    Report const report = wrong_report();
    Report const document = Report::parse(to_gradescope({{"anna", report}}, Language::en));
    double sum = 0;
    for (auto const& test : document.at("tests"))
        sum += test.at("score").get<double>();
    EXPECT_EQ(sum, document.at("score").get<double>());
    EXPECT_EQ(document.at("tests").size(), report.at("functions").size());
}

TEST(Gradescope, GivesNoScoreToWhatIsNotGradable)
{
    Report const document = Report::parse(to_gradescope({{"anna", not_gradable()}}, Language::de));
    EXPECT_FALSE(document.contains("score"));
    EXPECT_NE(document.at("output").get<std::string>().find("no compiler"), std::string::npos);
}

TEST(Formats, NameThePicturesWhereAllChecksPass)
{
    CheckResults results = passed_results(example_rubric());
    results.pictures.at(0).isolated.at(0).score = 0.5;
    Report const report = report_of(results, whole_build());
    EXPECT_NE(explain_function(report, "wrap_clamp", Language::en).find(results.pictures[0].name), std::string::npos);
    EXPECT_EQ(explain_function(report, "wrap_repeat", Language::en), "");
}

TEST(Sarif, PointsToTheCompilersLine)
{
    Report const report = report_of(passed_results(example_rubric()), mended_build());
    Report const document = Report::parse(to_sarif({{"anna", report}}, Language::en));
    EXPECT_EQ(document.at("version"), "2.1.0");
    auto const& results = document.at("runs").at(0).at("results");
    ASSERT_FALSE(results.empty());
    auto const& place = results.at(0).at("locations").at(0).at("physicalLocation");
    EXPECT_EQ(place.at("region").at("startLine"), report.at("build").at("diagnostics").at(0).at("line"));
    EXPECT_EQ(place.at("artifactLocation").at("uri"), "exercise_03.cpp");
}

TEST(Formats, TakeFilesThatDoNotCompile)
{
    Report const report = report_of(passed_results(example_rubric()), mended_build());
    for (auto const& format : formats())
        EXPECT_FALSE(format.write({{"anna", report}}, Language::de).empty()) << format.name;
}

TEST(Sarif, IsEmptyForARightSolution)
{
    Report const document = Report::parse(to_sarif({{"anna", right_report()}}, Language::en));
    EXPECT_TRUE(document.at("runs").at(0).at("results").empty());
}
}  // namespace testat
