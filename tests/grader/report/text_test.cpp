#include "report/text.h"

#include "example_grading.h"
#include "installation.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace testat {
namespace {
Report report_of(Rubric const& rubric, CheckResults const& results, Build const& build)
{
    Submission const submission{"exercise_03.cpp", "", std::string(64, '0'), {}};
    return make_report(submission, build, results, score(results, build, rubric, false), rubric, {"1", "", 7}, {}, {});
}

CheckResults failed_results()
{
    CheckResults results = passed_results(example_rubric());
    CheckResult& failed = find_result(results, "WrapClamp.Negative");
    failed.passed = false;
    failed.mismatch = Mismatch{"val = -1, size = 6", "-17", "5"};
    failed.detail = "expected 5";
    return results;
}

std::string failed_text(Language language)
{
    return report_to_text(report_of(example_rubric(), failed_results(), whole_build()), language);
}

testing::AssertionResult holds(std::string const& text, std::initializer_list<char const*> parts)
{
    for (char const* part : parts)
        if (text.find(part) == std::string::npos)
            return testing::AssertionFailure() << part << " is not in:\n" << text;
    return testing::AssertionSuccess();
}

/// Columns of the longest line that ends with "/ <points>".
std::size_t width_of_table(std::string const& text)
{
    std::istringstream lines(text);
    std::size_t widest = 0;
    for (std::string line; std::getline(lines, line);)
        if (line.size() > 8 && line.substr(line.size() - 8, 3) == " / ")
            widest = std::max(widest, std::size_t(std::count_if(line.begin(), line.end(),
                                                                [](char c) { return (c & 0xc0) != 0x80; })));
    return widest;
}
}  // namespace

TEST(ReportToText, BeginsWithThePoints)
{
    EXPECT_EQ(failed_text(Language::en).find("exercise_03.cpp: 1.25 of 2.00 points"), 0u) << failed_text(Language::en);
    EXPECT_EQ(failed_text(Language::de).find("exercise_03.cpp: 1.25 von 2.00 Punkten"), 0u)
        << failed_text(Language::de);
}

TEST(ReportToText, SaysWhatToFixFirstInOneOfTheFirstLines)
{
    std::string const text = failed_text(Language::en);
    EXPECT_LT(text.find("Fix first: wrap_clamp (-0.75): hint for WrapClamp.Negative"), text.find("Task b"));
    EXPECT_TRUE(holds(failed_text(Language::de), {"Zuerst beheben: wrap_clamp (-0.75): Hinweis zu"}));
}

TEST(ReportToText, IsTheSameWithColours)
{
    Report const report = report_of(example_rubric(), failed_results(), whole_build());
    std::string const coloured = report_to_text(report, Language::de, Ink::coloured);
    std::string const plain = report_to_text(report, Language::de);
    EXPECT_EQ(plain.find('\x1b'), std::string::npos);
    EXPECT_NE(coloured.find("\x1b[33mteilweise"), std::string::npos);
    EXPECT_EQ(std::regex_replace(coloured, std::regex("\x1b\\[[0-9]*m"), ""), plain);
}

TEST(ReportToText, HasNoColoursWhereNobodyLooks)
{
    EXPECT_EQ(isatty(STDOUT_FILENO) == 1 ? Ink::plain : ink_of_stdout(), Ink::plain);
}

TEST(ReportToText, HasTasksFunctionsAndVerdicts)
{
    EXPECT_TRUE(holds(failed_text(Language::en), {"Task b) Wrapping", "wrap_clamp", "partial", "0.25 /  1.00",
                                                  "wrap_repeat", "correct", "1.00 /  1.00"}));
    EXPECT_TRUE(holds(failed_text(Language::de),
                      {"Aufgabe b) Umgang mit Rändern", "wrap_clamp", "teilweise", "wrap_repeat", "richtig"}));
}

TEST(ReportToText, ShowsTheFirstMistake)
{
    EXPECT_TRUE(holds(failed_text(Language::en), {"wrap_clamp: WrapClamp.Negative", "val = -1, size = 6", "-17",
                                                  "expected 5", "hint for WrapClamp.Negative"}));
    EXPECT_TRUE(holds(failed_text(Language::de), {"val = -1, size = 6", "-17", "Hinweis zu WrapClamp.Negative"}));
}

TEST(ReportToText, ShowsNoMistakeOfWhatIsRight)
{
    std::string const text =
        report_to_text(report_of(example_rubric(), passed_results(example_rubric()), whole_build()), Language::en);
    EXPECT_TRUE(holds(text, {"2.00 of 2.00"}));
    EXPECT_EQ(text.find("hint"), std::string::npos) << text;
}

TEST(ReportToText, FitsInto80Columns)
{
    Rubric const rubric = read_rubric(installation().rubric);
    Report const report = report_of(rubric, passed_results(rubric), whole_build());
    for (Language language : {Language::de, Language::en}) {
        EXPECT_LE(width_of_table(report_to_text(report, language)), 80u);
        EXPECT_GE(width_of_table(report_to_text(report, language)), 60u);
    }
}

TEST(ReportToText, ShowsWhatDoesNotCompile)
{
    Build build;
    build.diagnostics = {{"exercise_03.cpp", 3, 1, "error", "'x' was not declared"}};
    std::string const text = report_to_text(report_of(example_rubric(), CheckResults{}, build), Language::en);
    EXPECT_TRUE(holds(text, {"0.00 of 2.00", "exercise_03.cpp:3", "'x' was not declared", "missing"}));
}

TEST(ReportToText, SaysThatNothingCouldBeGradedAlone)
{
    Report const report = report_of(example_rubric(), CheckResults{}, Build{});
    EXPECT_TRUE(holds(report_to_text(report, Language::en), {"No function could be graded by itself"}));
    EXPECT_TRUE(holds(report_to_text(report, Language::de), {"Auch einzeln ließ sich keine Funktion bewerten"}));
}

TEST(ReportToText, ShowsUnofficialPoints)
{
    Report const report = report_of(example_rubric(), passed_results(example_rubric()), mended_build());
    std::string const english = report_to_text(report, Language::en);
    EXPECT_TRUE(holds(english, {"0.00 of 2.00 points", "what does not compile gets 0 points", "1.00 of 1.00",
                                "wrap_clamp, line 3: 'x' was not declared", "Unofficially", "does not compile",
                                "0.00 /  1.00", "correct", "1.00 /  1.00", "1.00 /  2.00"}));
    EXPECT_EQ(english.find("by itself"), std::string::npos) << english;
    EXPECT_TRUE(holds(report_to_text(report, Language::de),
                      {"0.00 von 2.00 Punkten", "was nicht kompiliert, bekommt 0 Punkte", "1.00 von 1.00",
                       "wrap_clamp, Zeile 3: 'x' was not declared", "Inoffiziell", "kompiliert nicht", "richtig"}));
}

TEST(ReportToText, ShowsWhatElseDoesNotCompile)
{
    Build build = mended_build();
    build.broken.clear();
    build.left_out = {{"exercise_03.cpp", 2, 1, "error", "'junk' is no type"}};
    Report const report = report_of(example_rubric(), passed_results(example_rubric()), build);
    EXPECT_TRUE(holds(report_to_text(report, Language::en), {"line 2: 'junk' is no type", "2.00 of 2.00"}));
}

TEST(ReportToText, SaysWhatWasNotJudged)
{
    Build build;
    build.sources[Function::wrap_clamp] = {2, "int wrap_clamp() { x }"};
    Report const report = report_of(example_rubric(), CheckResults{}, build);
    EXPECT_TRUE(holds(report_to_text(report, Language::en), {"not judged", "missing"}));
    EXPECT_EQ(report_to_text(report, Language::en).find("wrong"), std::string::npos);
    EXPECT_TRUE(holds(report_to_text(report, Language::de), {"nicht bewertet", "fehlt"}));
}

TEST(ReportToText, SaysWhichPolicyApplies)
{
    Build build = whole_build();
    build.ok = false;
    Report const report = report_of(example_rubric(), passed_results(example_rubric()), build);
    EXPECT_TRUE(holds(report_to_text(report, Language::en), {"does not compile", "2.00"}));
}

TEST(ReportToText, ShowsPicturesThatDiffer)
{
    CheckResults results = passed_results(example_rubric());
    results.pictures[0].isolated[0].score = 0.5;
    results.pictures[0].isolated[0].rendering->comparison.outside = 1234;
    results.pictures[0].explained_by = {"wrap_clamp"};
    Report const report = report_of(example_rubric(), results, whole_build());
    EXPECT_TRUE(holds(report_to_text(report, Language::en), {"clamped", "1234", "because of wrap_clamp"}));
    EXPECT_TRUE(holds(report_to_text(report, Language::de), {"clamped", "1234", "wegen wrap_clamp"}));
    results.pictures[0].isolated[0].rendering->comparison.outside = 1;
    EXPECT_TRUE(
        holds(report_to_text(report_of(example_rubric(), results, whole_build()), Language::en), {"; 1 pixel wrong"}));
}

TEST(ReportToText, ShowsRemarks)
{
    CheckResults results = passed_results(example_rubric());
    results.remarks = {{"leaks", {Function::wrap_clamp}, {"Wächst.", "Grows."}}, {"races", {}, {"Wirr.", "Muddled."}}};
    Report const report = report_of(example_rubric(), results, whole_build());
    EXPECT_TRUE(holds(report_to_text(report, Language::en),
                      {"Remarks (they change no points)", "  wrap_clamp: Grows.", "  Muddled."}));
    EXPECT_TRUE(holds(report_to_text(report, Language::de), {"Anmerkungen", "  wrap_clamp: Wächst.", "  Wirr."}));
}

TEST(ReportToText, SaysWhyNothingWasGraded)
{
    Report const report = make_not_gradable({"a.cpp", "", std::string(64, '0'), {}}, {}, "the disk is full");
    EXPECT_TRUE(holds(report_to_text(report, Language::en), {"NOT GRADABLE", "the disk is full"}));
    EXPECT_TRUE(holds(report_to_text(report, Language::de), {"NICHT BEWERTBAR", "the disk is full"}));
}
}  // namespace testat
