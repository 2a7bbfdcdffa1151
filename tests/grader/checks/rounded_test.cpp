#include "checks/rounded.h"

#include "checks/matrices.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_inverse.hpp>

namespace testat {
namespace {
bool holds(Rounded bound, float measured)
{
    return std::abs(double(measured) - bound.value) <= bound.error;
}

float any_float(Random& random)
{
    return static_cast<float>(random.uniform(-2, 2) * std::exp2(random.integer(-20, 20)));
}
}  // namespace

TEST(Rounded, HoldsWhatFloatComesTo)
{
    Random random(1, "rounded");
    for (int i = 0; i < 100'000; ++i) {
        float const a = any_float(random);
        float const b = any_float(random);
        float const c = any_float(random);
        ASSERT_TRUE(holds(Rounded(a) * b + c, a * b + c));
        ASSERT_TRUE(holds((Rounded(a) + b - c) / b, (a + b - c) / b));
        ASSERT_TRUE(holds(sqrt(Rounded(a) * a + Rounded(b) * b), std::sqrt(a * a + b * b)));
    }
}

/// Errors are no larger than twice what roundings make at worst here: three of them.
TEST(Rounded, IsNoWiderThanItsRoundings)
{
    Rounded const sum = Rounded(1) * 1 + Rounded(1) * 1;
    EXPECT_NEAR(sum.error, 4 * eps, 1e-12);
}

TEST(Rounded, LosesNothingFromAnExactZero)
{
    EXPECT_EQ((Rounded(0) * 5 + 0).error, 0);
    EXPECT_EQ((Rounded(3) - 3).error, 0);
    EXPECT_GT((Rounded(1, eps) - 1).error, 0);
}

TEST(Rounded, KnowsThatTheSmallestNumbersAreCoarse)
{
    float const small = 1e-30f;
    EXPECT_TRUE(holds(Rounded(small) * 1e-14f, small * 1e-14f));
    EXPECT_GE((Rounded(small) * 1e-20f).error, 1e-50);
}

TEST(Rounded, SaysNothingOfAQuotientByWhatMayBeZero)
{
    EXPECT_EQ((Rounded(1) / Rounded(1, 1)).error, HUGE_VAL);
    EXPECT_EQ((Rounded(1) / Rounded(1, 1) * 0).error, HUGE_VAL);
    EXPECT_LT((Rounded(1) / Rounded(1, 0.5)).error, 1.1);
}

TEST(Rounded, TellsSignsForSure)
{
    EXPECT_EQ(is_positive(Rounded(1, 0.5)), Certainty::yes);
    EXPECT_EQ(is_positive(Rounded(1, 1)), Certainty::perhaps);
    EXPECT_EQ(is_positive(Rounded(-1, 0.5)), Certainty::no);
    EXPECT_EQ(is_positive(Rounded(0)), Certainty::no);
    EXPECT_EQ(is_positive(Rounded(1, HUGE_VAL)), Certainty::perhaps);
}

TEST(RoundedTransform, HoldsGlmsInverse)
{
    Random random(1, "inverse");
    for (int i = 0; i < 10'000; ++i) {
        glm::dmat4 m(0);
        for (int column = 0; column < 4; ++column)
            m[column] = glm::dvec4(random_vector(random, 2), column == 3);
        float stored[16];
        store(m, stored);
        glm::mat4 const inverted = glm::inverse(glm::mat4(dmat4(stored)));
        RoundedTransform const bound = inverse(exact_transform(stored));
        for (int column = 0; column < 3; ++column)
            ASSERT_TRUE(holds(bound.columns[column].x, inverted[column].x) &&
                        holds(bound.columns[column].y, inverted[column].y) &&
                        holds(bound.columns[column].z, inverted[column].z));
        ASSERT_TRUE(holds(bound.translation.x, inverted[3].x) && holds(bound.translation.y, inverted[3].y) &&
                    holds(bound.translation.z, inverted[3].z));
    }
}
}  // namespace testat
