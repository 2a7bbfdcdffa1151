#include "checks/random.h"

#include <gtest/gtest.h>

#include <climits>

namespace testat {
TEST(Random, IsTheSameOnEveryMachine)
{
    Random random(1, "check");
    EXPECT_EQ(random.integer(0, 999'999), 760'539);
    EXPECT_EQ(random.integer(-10, 10), 1);
    EXPECT_EQ(random.uniform(0, 1), 0x1.da98356ce36a6p-1);
}

TEST(Random, DependsOnSeedAndName)
{
    EXPECT_NE(Random(1, "a").uniform(0, 1), Random(2, "a").uniform(0, 1));
    EXPECT_NE(Random(1, "a").uniform(0, 1), Random(1, "b").uniform(0, 1));
    EXPECT_NE(Random(0, "a").uniform(0, 1), Random(0, "b").uniform(0, 1));
}

TEST(Random, StaysInItsRange)
{
    Random random(1, "range");
    for (int i = 0; i < 10'000; ++i) {
        double const x = random.uniform(-2, 3);
        ASSERT_TRUE(x >= -2 && x < 3) << x;
        int const n = random.integer(-1, 1);
        ASSERT_TRUE(n >= -1 && n <= 1) << n;
    }
}

TEST(Random, ReachesBothEnds)
{
    Random random(1, "ends");
    bool lowest = false, highest = false;
    for (int i = 0; i < 1000; ++i) {
        int const n = random.integer(-1, 1);
        lowest = lowest || n == -1;
        highest = highest || n == 1;
    }
    EXPECT_TRUE(lowest && highest);
}

TEST(Random, TakesTheWholeRangeOfInt)
{
    Random random(1, "whole");
    EXPECT_NE(random.integer(INT_MIN, INT_MAX), random.integer(INT_MIN, INT_MAX));
    EXPECT_EQ(random.integer(INT_MAX, INT_MAX), INT_MAX);
}
}  // namespace testat
