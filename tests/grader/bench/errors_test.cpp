#include "bench/errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat::bench {
namespace {
TEST(Rmse, IsZeroForTheTruthAndTheDifferenceForAConstantOne)
{
    Truth const truth(3, glm::dvec3(0.25, 0.5, 0.75));
    EXPECT_EQ(rmse(Colours(3, {0.25f, 0.5f, 0.75f, 7}), truth), 0);
    EXPECT_NEAR(rmse(Colours(3, {0.5f, 0.75f, 1.f, 7}), truth), 0.25, 1e-12);
}

TEST(DeltaE, KnowsWhiteBlackAndMiddleGrey)
{
    Truth const white(1, glm::dvec3(1));
    EXPECT_NEAR(mean_delta_e(Colours(1, glm::vec4(1)), white), 0, 1e-9);
    EXPECT_NEAR(mean_delta_e(Colours(1, glm::vec4(0)), white), 100, 0.05);
    // 18.42 % is L* = 50.
    EXPECT_NEAR(mean_delta_e(Colours(1, glm::vec4(0.18419f)), white), 50, 0.05);
}

/// L*a*b* of sRGB's red is (53.24, 80.09, 67.20).
TEST(DeltaE, SeesColour)
{
    EXPECT_NEAR(mean_delta_e(Colours(1, {1, 0, 0, 1}), Truth(1, glm::dvec3(0))), std::hypot(53.24, 80.09, 67.20), 0.1);
}

TEST(Errors, AreNotFiniteIfAColourIsNot)
{
    for (float bad : {NAN, INFINITY}) {
        EXPECT_FALSE(std::isfinite(rmse(Colours(1, {bad, 0, 0, 1}), Truth(1))));
        EXPECT_FALSE(std::isfinite(mean_delta_e(Colours(1, {0, bad, 0, 1}), Truth(1))));
    }
}
}  // namespace
}  // namespace testat::bench
