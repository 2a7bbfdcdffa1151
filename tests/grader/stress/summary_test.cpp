#include "stress/stress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace testat {
namespace {
FunctionStress summary(std::vector<float> errors)
{
    FunctionStress result;
    result.inside.errors = std::move(errors);
    summarize(result);
    return result;
}
}  // namespace

TEST(Summary, IsOfTheSortedErrors)
{
    std::vector<float> errors(1000);
    std::iota(errors.rbegin(), errors.rend(), 1.f);
    FunctionStress const result = summary(errors);
    EXPECT_EQ(result.median, 500);
    EXPECT_EQ(result.p999, 999);
    EXPECT_EQ(result.max, 1000);
}

TEST(Summary, OfOneErrorIsThatError)
{
    FunctionStress const result = summary({0.25f});
    EXPECT_EQ(result.median, 0.25);
    EXPECT_EQ(result.p999, 0.25);
    EXPECT_EQ(result.max, 0.25);
}

TEST(Summary, PutsInfinityLast)
{
    EXPECT_EQ(summary({HUGE_VALF, 0, 1}).max, HUGE_VAL);
    EXPECT_EQ(summary({HUGE_VALF, 0, 1}).median, 1);
}

TEST(Summary, OfNothingIsNoNumber)
{
    EXPECT_TRUE(std::isnan(summary({}).max));
}
}  // namespace testat
