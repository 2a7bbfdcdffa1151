#include "report/reading.h"

#include "example_grading.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Report report_of(CheckResults const& results, Build const& build)
{
    Rubric const rubric = example_rubric();
    return make_report({}, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, {}, {});
}

CheckResults without(std::vector<std::string> const& failed)
{
    CheckResults results = passed_results(example_rubric());
    for (auto const& name : failed)
        find_result(results, name).passed = false;
    return results;
}
}  // namespace

TEST(FirstFix, IsNothingWhereAllIsRight)
{
    Report const report = report_of(without({}), whole_build());
    EXPECT_FALSE(Reading(report).first_fix());
}

TEST(FirstFix, IsWhatCostsMost)
{
    Report const report = report_of(without({"WrapClamp.Negative", "WrapRepeat.Inside"}), whole_build());
    auto const fix = Reading(report).first_fix();
    ASSERT_TRUE(fix);
    EXPECT_EQ(fix->function, "wrap_repeat");
    EXPECT_EQ(fix->lost, 1);
    EXPECT_EQ(fix->what.en, "hint for WrapRepeat.Inside");
}

TEST(FirstFix, IsTheNamedMistakeWithTheHintOfItsCheck)
{
    Report report = report_of(without({"WrapClamp.Negative"}), whole_build());
    report["functions"]["wrap_clamp"]["mistake"] = {{"id", "m"}, {"de", "Fehler"}, {"en", "mistake"}};
    auto const fix = Reading(report).first_fix();
    ASSERT_TRUE(fix);
    EXPECT_EQ(fix->what.de, "Fehler");
    EXPECT_EQ(fix->hint.en, "hint for WrapClamp.Negative");
}

TEST(FirstFix, GoesForWhatIsWrittenBeforeWhatIsNot)
{
    Report report = report_of(without({"WrapClamp.Negative", "WrapRepeat.Inside"}), whole_build());
    report["functions"]["wrap_repeat"]["verdict"] = "missing";
    EXPECT_EQ(Reading(report).first_fix()->function, "wrap_clamp");
    report["functions"]["wrap_clamp"]["earned"] = 1;
    EXPECT_EQ(Reading(report).first_fix()->function, "wrap_repeat");
}

TEST(FirstFix, GoesForWhatACheckFoundBeforeWhatOnlyPicturesShow)
{
    Report report = report_of(without({"WrapClamp.Negative"}), whole_build());
    report["functions"]["wrap_repeat"]["earned"] = 0;
    EXPECT_EQ(Reading(report).first_fix()->function, "wrap_clamp");
}

TEST(FirstFix, IsTheCrashThatCostsAll)
{
    Report report = report_of(without({"WrapClamp.Negative", "WrapRepeat.Inside"}), whole_build());
    report["functions"]["wrap_clamp"]["verdict"] = "crashed";
    report["policy"]["applied"] = {"crashes"};
    EXPECT_EQ(Reading(report).first_fix()->function, "wrap_clamp");
}

TEST(FirstFix, IsTheFirstErrorOfWhatDoesNotCompile)
{
    Report const report = report_of(without({}), mended_build());
    auto const fix = Reading(report).first_fix();
    ASSERT_TRUE(fix);
    EXPECT_EQ(fix->function, "wrap_clamp");
    EXPECT_EQ(fix->hint.en, "'x' was not declared");
    EXPECT_EQ(fix->line, 3);
    EXPECT_EQ(fix->lost, 2);
}
}  // namespace testat
