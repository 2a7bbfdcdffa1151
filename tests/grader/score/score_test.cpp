#include "score/score.h"

#include "example_grading.h"

#include <gtest/gtest.h>

#include <functional>

namespace testat {
namespace {
/// The grade of a right upload after this change.
Grade grade_after(std::function<void(CheckResults&, Build&)> const& change, bool lenient = false)
{
    Rubric const rubric = example_rubric();
    CheckResults results = passed_results(rubric);
    Build build = whole_build();
    change(results, build);
    return score(results, build, rubric, lenient);
}

Grade without_check(std::string const& name)
{
    return grade_after([&](CheckResults& r, Build&) { find_result(r, name).passed = false; });
}

Grade with_picture_score(double picture)
{
    return grade_after([=](CheckResults& r, Build&) { r.pictures[0].isolated[0].score = picture; });
}

FunctionVerdict verdict_with_end(Ended ended)
{
    return grade_after([=](CheckResults& r, Build&) {
               find_result(r, "WrapClamp.Negative").passed = false;
               find_result(r, "WrapClamp.Negative").ended = ended;
           })
        .functions[0]
        .verdict;
}
}  // namespace

TEST(RoundHalfUp, RoundsToTheStep)
{
    EXPECT_EQ(round_half_up(0.125, 0.25), 0.25);
    EXPECT_EQ(round_half_up(0.12, 0.25), 0);
    EXPECT_EQ(round_half_up(0.374, 0.25), 0.25);
    EXPECT_EQ(round_half_up(0.375, 0.25), 0.5);
    EXPECT_EQ(round_half_up(2, 0.25), 2);
    EXPECT_EQ(round_half_up(0, 0.25), 0);
    EXPECT_EQ(round_half_up(1.5, 1), 2);
}

TEST(RoundHalfUp, ForgivesTheRoundingsOfWeights)
{
    EXPECT_EQ(round_half_up((0.1 + 0.7 + 0.1 - 0.025) * 1.0 - 1e-16, 0.25), 1);
    EXPECT_EQ(round_half_up(0.125 - 1e-12, 0.25), 0.25);
    EXPECT_EQ(round_half_up(0.125 - 1e-6, 0.25), 0);
}

TEST(Score, GivesEverythingForARightFile)
{
    Grade const grade = grade_after([](CheckResults&, Build&) {});
    EXPECT_EQ(grade.earned, 2);
    EXPECT_EQ(grade.max, 2);
    EXPECT_TRUE(grade.passed);
    EXPECT_TRUE(grade.policies.empty());
    EXPECT_EQ(grade.functions[0].verdict, FunctionVerdict::correct);
}

TEST(Score, WeighsChecks)
{
    Grade const grade = without_check("WrapClamp.Negative");
    EXPECT_EQ(grade.functions[0].unit, 0.25);
    EXPECT_EQ(grade.functions[0].earned, 0.25);
    EXPECT_EQ(grade.functions[0].verdict, FunctionVerdict::partial);
    EXPECT_EQ(grade.functions[1].earned, 1);
}

TEST(Score, GivesNothingWithoutTheEssentialCheck)
{
    Grade const grade = without_check("WrapClamp.Inside");
    EXPECT_EQ(grade.functions[0].unit, 0);
    EXPECT_EQ(grade.functions[0].earned, 0);
    EXPECT_EQ(grade.functions[0].verdict, FunctionVerdict::wrong);
}

TEST(Score, TakesHalfForPicturesAtMost)
{
    EXPECT_EQ(with_picture_score(0).functions[0].earned, 0.5);
    EXPECT_EQ(with_picture_score(0.5).functions[0].earned, 0.75);
    EXPECT_EQ(with_picture_score(0).functions[0].verdict, FunctionVerdict::partial);
    EXPECT_EQ(with_picture_score(0).functions[1].picture, 1) << "it has none";
}

TEST(Score, TakesPointsForOneMistakeOnce)
{
    Grade const grade = grade_after([](CheckResults& r, Build&) {
        find_result(r, "WrapClamp.Negative").passed = false;
        r.pictures[0].isolated[0].score = 0;
    });
    EXPECT_EQ(grade.functions[0].earned, 0.25) << "min(0.25, 0.5)";
}

TEST(Score, CountsAPictureForEachFunctionByItself)
{
    Grade const grade = grade_after([](CheckResults& r, Build&) {
        r.pictures[0].isolated.push_back({Function::wrap_repeat, std::nullopt, 0});
    });
    EXPECT_EQ(grade.functions[0].picture, 1);
}

TEST(Score, CountsAMissingPictureAsWrong)
{
    Grade const grade = grade_after([](CheckResults& r, Build&) { r.pictures.clear(); });
    EXPECT_EQ(grade.functions[0].picture, 0);
    EXPECT_EQ(grade.functions[0].earned, 0.5);
}

TEST(Score, CountsAMissingCheckAsFailed)
{
    Grade const grade = grade_after([](CheckResults& r, Build&) { r.checks.clear(); });
    EXPECT_EQ(grade.earned, 0);
}

TEST(Score, PassesFromTheFractionOn)
{
    EXPECT_TRUE(without_check("WrapClamp.Negative").passed) << "1.25 of 2";
    EXPECT_FALSE(without_check("WrapClamp.Inside").passed) << "1 of 2";
}

TEST(Verdict, NamesWhatIsMissing)
{
    auto const lacks_clamp = [](CheckResults&, Build& b) { b.defined = b.defined.without(Function::wrap_clamp); };
    EXPECT_EQ(grade_after(lacks_clamp).functions[0].verdict, FunctionVerdict::missing);
    EXPECT_EQ(grade_after(lacks_clamp).functions[1].verdict, FunctionVerdict::correct);
}

TEST(Verdict, IsWrongIfItIsThereButNothingCouldBeRun)
{
    Grade const grade = grade_after([](CheckResults& r, Build& b) {
        r = {};
        b = {};
        b.sources[Function::wrap_clamp] = {1, "int ImageTexture::wrap_clamp"};
    });
    EXPECT_EQ(grade.functions[0].verdict, FunctionVerdict::wrong);
    EXPECT_EQ(grade.functions[1].verdict, FunctionVerdict::missing);
}

TEST(Verdict, NamesHowACheckEnded)
{
    EXPECT_EQ(verdict_with_end(Ended::timed_out), FunctionVerdict::timed_out);
    EXPECT_EQ(verdict_with_end(Ended::signal), FunctionVerdict::crashed);
    EXPECT_EQ(verdict_with_end(Ended::exception), FunctionVerdict::crashed);
    EXPECT_EQ(verdict_with_end(Ended::exit), FunctionVerdict::crashed);
    EXPECT_EQ(verdict_with_end(Ended::answered), FunctionVerdict::partial);
}

TEST(Verdict, NamesHowAPictureEnded)
{
    Grade const grade =
        grade_after([](CheckResults& r, Build&) { r.pictures[0].isolated[0].rendering->ended = Ended::signal; });
    EXPECT_EQ(grade.functions[0].verdict, FunctionVerdict::crashed);
    EXPECT_EQ(grade.functions[1].verdict, FunctionVerdict::correct);
}

TEST(Policy, GivesNothingForAFileThatDoesNotCompile)
{
    auto const broken = [](CheckResults&, Build& b) { b.ok = false; };
    Grade const grade = grade_after(broken);
    EXPECT_EQ(grade.earned, 0);
    EXPECT_EQ(grade.earned_without, 2);
    EXPECT_FALSE(grade.passed);
    EXPECT_EQ(grade.policies, std::vector<std::string>{"does_not_compile"});
}

TEST(Policy, LooksAtPicturesAsSubmitted)
{
    auto const crashes = [](CheckResults& r, Build&) { r.pictures[0].submitted->ended = Ended::signal; };
    EXPECT_EQ(grade_after(crashes).earned, 0.5);
    EXPECT_EQ(grade_after(crashes).policies, std::vector<std::string>{"crashes"});
    auto const alone = [](CheckResults& r, Build&) { r.pictures[0].isolated[0].rendering->ended = Ended::signal; };
    EXPECT_TRUE(grade_after(alone).policies.empty());
}

TEST(Policy, AppliesToTheEndsItNames)
{
    auto const late = [](CheckResults& r, Build&) { r.pictures[0].submitted->ended = Ended::timed_out; };
    EXPECT_TRUE(grade_after(late).policies.empty());
    auto const not_asked = [](CheckResults& r, Build&) { r.pictures[0].submitted.reset(); };
    EXPECT_TRUE(grade_after(not_asked).policies.empty());
}

TEST(Policy, NeverGivesMoreThanWasEarned)
{
    Grade const grade = grade_after([](CheckResults& r, Build&) {
        r.pictures[0].submitted->ended = Ended::exit;
        for (auto& check : r.checks)
            check.passed = false;
    });
    EXPECT_EQ(grade.earned, 0);
}

TEST(Policy, IsLeftOutForTheLenient)
{
    Grade const grade = grade_after([](CheckResults&, Build& b) { b.ok = false; }, true);
    EXPECT_EQ(grade.earned, 2);
    EXPECT_TRUE(grade.policies.empty());
}

TEST(Score, KeepsUnofficialPointsApart)
{
    Grade const grade = grade_after([](CheckResults&, Build& build) {
        build.ok = false;
        build.mended = true;
        build.sources[Function::wrap_clamp] = build.sources[Function::wrap_repeat] = {};
        build.broken[Function::wrap_clamp] = {"exercise_03.cpp", 3, 1, "error", "broken"};
        build.defined = build.defined.without(Function::wrap_clamp);
    });
    EXPECT_EQ(grade.earned, 0);
    EXPECT_EQ(grade.earned_without, 0);
    for (auto const& function : grade.functions) {
        EXPECT_EQ(function.earned, 0);
        EXPECT_EQ(function.verdict, FunctionVerdict::wrong);
    }
    ASSERT_EQ(grade.unofficial.size(), 1u);
    EXPECT_EQ(grade.unofficial[0].function, Function::wrap_repeat);
    EXPECT_EQ(grade.unofficial[0].earned, 1);
    EXPECT_EQ(grade.unofficial[0].verdict, FunctionVerdict::correct);
}

/// Leniency forgives rules, not errors of the compiler.
TEST(Score, KeepsUnofficialPointsApartWithLeniencyToo)
{
    auto const mended = [](CheckResults&, Build& build) {
        build.ok = false;
        build.mended = true;
        build.broken[Function::wrap_clamp] = {};
    };
    EXPECT_EQ(grade_after(mended, true).earned, 0);
}

TEST(Score, HasUnofficialPointsBesideAMissingFunction)
{
    Grade const grade = grade_after([](CheckResults&, Build& build) {
        build.ok = false;
        build.broken[Function::wrap_clamp] = {"exercise_03.cpp", 0, 0, "error", "missing"};
    });
    EXPECT_EQ(grade.unofficial.size(), 1u);
    EXPECT_EQ(grade.earned, 0);
    EXPECT_TRUE(grade_after([](CheckResults&, Build&) {}).unofficial.empty());
}
}  // namespace testat
