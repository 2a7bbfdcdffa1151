#include "bench/bench.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat::bench {
namespace {
using Scores = std::map<std::string, Score>;

TEST(ParetoFront, KeepsWhatNobodyBeats)
{
    Scores const scores = {
        {"fast", {1, 0.5, 0}}, {"good", {9, 0.1, 0}}, {"between", {4, 0.2, 0}}, {"beaten", {5, 0.3, 0}}};
    EXPECT_EQ(pareto_front(scores), (std::vector<std::string>{"fast", "between", "good"}));
}

TEST(ParetoFront, KeepsBothOfTwoThatAreAlike)
{
    EXPECT_EQ(pareto_front({{"a", {1, 0.5, 0}}, {"b", {1, 0.5, 0}}}).size(), 2u);
}

/// Zero is what an impossible time becomes: an upload gains nothing by lying.
TEST(ParetoFront, LeavesOutWhatHasNoTimeOrNoError)
{
    EXPECT_TRUE(pareto_front({{"untimed", {0, 0.1, 0}}, {"nan", {1, NAN, 0}}, {"infinite", {1, INFINITY, 0}}}).empty());
    EXPECT_EQ(pareto_front({{"untimed", {0, 0.1, 0}}, {"right", {5, 0.2, 0}}}), std::vector<std::string>{"right"});
}

TEST(MeanScores, WeightTimesByPixelsAndSquareErrors)
{
    BenchResults results;
    results.filters = {{"a", {}, Family::fast}, {"b", {}, Family::fast}};
    results.cases = {{"s", "checker", 256, 300, {{"a", {10, 0.3, 1}}, {"b", {1, 1, 1}}}},
                     {"t", "checker", 256, 100, {{"a", {50, 0.4, 3}}}},
                     {"t", "noise", 256, 100, {{"a", {1, 9, 9}}}}};
    Scores const means = mean_scores(results, "checker");
    EXPECT_EQ(means.count("b"), 0u);
    EXPECT_NEAR(means.at("a").ns, 20, 1e-12);
    EXPECT_NEAR(means.at("a").rmse, std::sqrt((0.09 + 0.16) / 2), 1e-12);
    EXPECT_NEAR(means.at("a").delta_e, 2, 1e-12);
}

TEST(MeanScores, KnowNoTimeWhereOneIsMissing)
{
    BenchResults results;
    results.filters = {{"a", {}, Family::upload}};
    results.cases = {{"s", "checker", 256, 1, {{"a", {10, 0.3, 1}}}}, {"t", "checker", 256, 1, {{"a", {0, 0.3, 1}}}}};
    EXPECT_EQ(mean_scores(results).at("a").ns, 0);
}
}  // namespace
}  // namespace testat::bench
