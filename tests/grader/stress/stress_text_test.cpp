#include "stress/stress_report.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
FunctionStress example()
{
    FunctionStress result;
    result.function = Function::wrap_clamp;
    result.written = true;
    result.inside.counts.asked = 4;
    result.inside.counts.crashed = 3;
    result.inside.errors = {0, 0.125f, HUGE_VALF};
    result.inside.worst_error = HUGE_VAL;
    result.inside.worst = Mismatch{"val = 1", "2", "3"};
    summarize(result);
    return result;
}

std::string text_of(std::vector<FunctionStress> const& results, Language language, bool builds = true)
{
    Build build;
    build.ok = builds;
    if (!builds)
        build.diagnostics = {{"exercise_03.cpp", 12, 1, "error", "expected ';'"}};
    return stress_to_text(stress_to_json({"exercise_03.cpp", "", "", {}}, build, {}, results), language);
}

bool contains(std::string const& text, std::string const& part)
{
    return text.find(part) != std::string::npos;
}
}  // namespace

TEST(StressText, ShowsErrorsAndWorstInputs)
{
    std::string const text = text_of({example()}, Language::en);
    EXPECT_TRUE(
        contains(text, "wrap_clamp                                   4     0.125         ∞         ∞         1"))
        << text;
    EXPECT_TRUE(contains(text, "wrap_clamp: 3 crash")) << text;
    EXPECT_TRUE(contains(text, "val = 1")) << text;
}

TEST(StressText, IsGermanOnRequest)
{
    std::string const text = text_of({example()}, Language::de);
    EXPECT_TRUE(contains(text, "3 Absturz")) << text;
    EXPECT_FALSE(contains(text, "crash")) << text;
}

TEST(StressText, SaysWhatDoesNotCompile)
{
    std::string const text = text_of({}, Language::en, false);
    EXPECT_TRUE(contains(text, "does not compile")) << text;
    EXPECT_TRUE(contains(text, "exercise_03.cpp:12: error: expected ';'")) << text;
}

TEST(StressText, SaysWhatIsNotWritten)
{
    FunctionStress missing;
    missing.function = Function::intersect;
    EXPECT_TRUE(contains(text_of({missing}, Language::en), "not written"));
}
}  // namespace testat
