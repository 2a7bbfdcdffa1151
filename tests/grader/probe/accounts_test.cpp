#include "probe/accounts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat {
namespace {
constexpr Limits limits{10, 1, 20, 3, 60, 90};
FunctionSet const clamp = FunctionSet::only(Function::wrap_clamp);
FunctionSet const repeat = FunctionSet::only(Function::wrap_repeat);
}  // namespace

TEST(Accounts, GiveAGroupItsLimit)
{
    EXPECT_EQ(Accounts(limits, {}).limit_for(clamp, 0), 10);
}

TEST(Accounts, GiveFunctionsThatHaveHungLittle)
{
    Accounts accounts(limits, {});
    accounts.charge(clamp, 10, 10, true);
    EXPECT_EQ(accounts.limit_for(clamp, 10), 1);
    EXPECT_EQ(accounts.limit_for(FunctionSet::all(), 10), 1);
    EXPECT_EQ(accounts.limit_for(repeat, 10), 10);
    EXPECT_EQ(Accounts(limits, clamp).limit_for(clamp, 0), 1);
}

TEST(Accounts, EndForFunctionsThatHangAgainAndAgain)
{
    Accounts accounts(limits, {});
    accounts.charge(clamp, 10, 10, true);
    for (int i = 0; i < 3; ++i)
        accounts.charge(clamp, 1, 1, true);
    EXPECT_EQ(accounts.limit_for(clamp, 13), 0);
    EXPECT_GT(accounts.limit_for(repeat, 13), 0);
}

TEST(Accounts, EndForSlowFunctions)
{
    Accounts accounts(limits, {});
    for (int i = 0; i < 3; ++i)
        accounts.charge(clamp, 7, 7, false);
    EXPECT_EQ(accounts.limit_for(clamp, 21), 0);
    EXPECT_GT(accounts.limit_for(repeat, 21), 0);
}

TEST(Accounts, LeaveSomethingBehindSixHangingFunctions)
{
    Accounts accounts(limits, {});
    double elapsed = 0;
    for (unsigned f = 0; f < 6; ++f)
        for (int group = 0; group < 10; ++group) {
            auto const functions = FunctionSet::only(every_function()[f]);
            double const limit = accounts.limit_for(functions, elapsed);
            if (limit > 0)
                accounts.charge(functions, limit, limit, true);
            elapsed += limit;
        }
    EXPECT_LT(elapsed, 60);
    EXPECT_GE(accounts.limit_for(FunctionSet::only(every_function()[7]), elapsed), 1);
}

TEST(Accounts, CountSleepAsTime)
{
    Accounts accounts(limits, {});
    accounts.charge(clamp, 0, 41, false);
    EXPECT_EQ(accounts.limit_for(clamp, 41), 0);
}

TEST(Accounts, EndWithTheRequestsTime)
{
    Accounts accounts(limits, {});
    EXPECT_EQ(accounts.limit_for(repeat, 90), 0);
    accounts.charge(clamp, 60, 30, false);
    EXPECT_EQ(accounts.limit_for(repeat, 30), 0);
}

TEST(Accounts, AreEndlessWithoutLimits)
{
    Accounts accounts({5, 1, 20, 20, HUGE_VAL, HUGE_VAL}, {});
    accounts.charge(clamp, 1000, 1000, false);
    EXPECT_EQ(accounts.limit_for(repeat, 1e6), 5);
}
}  // namespace testat
