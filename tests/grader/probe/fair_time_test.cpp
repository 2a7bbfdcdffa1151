#include "probe/fair_time.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat {
TEST(FairTime, PassesByTheClockForWhoComputes)
{
    FairTime time;
    time.pass(2, 2);
    time.pass(2, 8);  // four threads
    EXPECT_EQ(time.spent_s(), 4);
}

TEST(FairTime, PassesByTheClockForWhoSleeps)
{
    FairTime time;
    time.pass(2, 0);
    time.pass(2, 0.01);
    EXPECT_EQ(time.spent_s(), 4);
}

TEST(FairTime, PassesSlowlyWhereThereIsNoProcessor)
{
    FairTime time;
    time.pass(2, 0.25);
    EXPECT_EQ(time.spent_s(), 0.5);
}

TEST(FairTime, PassesWhereNothingIsKnown)
{
    FairTime time;
    time.pass(2, HUGE_VAL);
    EXPECT_EQ(time.spent_s(), 2);
}
}  // namespace testat
