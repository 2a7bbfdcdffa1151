#include "digits.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {
bool has_ink(int number, glm::vec2 const& p)
{
    return stroke_distance(number_strokes(number), p, 0.1f) < 0.f;
}

float largest_x(int number)
{
    float x = 0.f;
    for (Segment const& segment : number_strokes(number))
        x = std::max({x, segment.from.x, segment.to.x});
    return x;
}
}  // namespace

TEST(Digits, MiddlesAndHoles)
{
    EXPECT_FALSE(has_ink(0, {0.f, 0.f}));
    EXPECT_TRUE(has_ink(8, {0.f, 0.f}));
    EXPECT_TRUE(has_ink(1, {0.06f, -0.4f}));
    EXPECT_FALSE(has_ink(7, {-0.2f, 0.f}));
}

TEST(Digits, SixAndNineAreUnderlined)
{
    EXPECT_TRUE(has_ink(6, {0.f, -0.78f}));
    EXPECT_TRUE(has_ink(9, {0.f, -0.78f}));
    EXPECT_FALSE(has_ink(8, {0.f, -0.78f}));
}

TEST(Digits, NineIsSixTurned)
{
    for (glm::vec2 const& p :
         {glm::vec2(0.f, 0.f), glm::vec2(0.29f, 0.2f), glm::vec2(-0.2f, 0.3f), glm::vec2(0.f, 0.2f)})
        EXPECT_EQ(has_ink(9, p), has_ink(6, -p));
}

TEST(Digits, TwoDigitsAreWider)
{
    EXPECT_GT(largest_x(10), largest_x(1) + 0.3f);
    EXPECT_TRUE(has_ink(11, {-0.37f, 0.f}));
}
