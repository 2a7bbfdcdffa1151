#include "watch/changes.h"

#include "example_grading.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Report report_of(CheckResults const& results, Build const& build = whole_build())
{
    Rubric const rubric = example_rubric();
    return make_report({}, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, {}, {});
}

bool says(std::string const& text, std::string const& words)
{
    return text.find(words) != std::string::npos;
}
}  // namespace

TEST(Changes, TellPointsGainedAndTheFirstMistake)
{
    CheckResults const right = passed_results(example_rubric());
    CheckResults wrong = right;
    find_result(wrong, "WrapClamp.Negative").passed = false;
    Report const before = report_of(wrong), after = report_of(right);
    std::string const lost = changes_to_text(&after, before, Language::en);
    EXPECT_TRUE(says(lost, "(-0.75)")) << lost;
    EXPECT_TRUE(says(lost, "1.00 ->  0.25  -0.75")) << lost;
    EXPECT_TRUE(says(lost, "wrap_clamp: WrapClamp.Negative")) << lost;
    std::string const gained = changes_to_text(&before, after, Language::de);
    EXPECT_TRUE(says(gained, "(+0.75)")) << gained;
    EXPECT_TRUE(says(gained, "alle Prüfungen bestanden")) << gained;
}

TEST(Changes, TellNothingTwice)
{
    Report const same = report_of(passed_results(example_rubric()));
    EXPECT_TRUE(says(changes_to_text(&same, same, Language::en), "(unchanged)"));
    EXPECT_FALSE(says(changes_to_text(nullptr, same, Language::en), "("));
}

TEST(Changes, TellTheCompilersFirstMessage)
{
    Build build = whole_build();
    build.ok = false;
    build.diagnostics = {{"exercise_03.cpp", 7, 1, "error", "expected ';'"},
                         {"exercise_03.cpp", 9, 1, "error", "other"}};
    std::string const text = changes_to_text(nullptr, report_of(passed_results(example_rubric()), build), Language::en);
    EXPECT_TRUE(says(text, "exercise_03.cpp:7: error: expected ';'")) << text;
    EXPECT_FALSE(says(text, "other")) << text;
}
}  // namespace testat
