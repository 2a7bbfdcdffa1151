#include "texture_files.h"

#include <gtest/gtest.h>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <string>

namespace {
int const width = 1024;
int const height = 512;

Image ball(int number)
{
    return texture_file("pool_ball_" + std::to_string(number));
}

bool is_white(glm::vec4 const& texel)
{
    return texel.r > 0.9f && texel.g > 0.9f && texel.b > 0.85f;
}

/// The texel at an angle from the middle of the disc at u = 1/4, in a direction on the ball; both in radians.
glm::vec4 around_disc(Image const& image, float angle, float direction)
{
    float const y = std::sin(angle) * std::sin(direction);
    float const longitude = std::atan2(std::sin(angle) * std::cos(direction), std::cos(angle));
    float const u = 0.25f + longitude / glm::two_pi<float>();
    float const v = 0.5f + std::asin(y) / glm::pi<float>();
    return image.getPixel(int(u * float(width)), int(v * float(height)));
}
}  // namespace

TEST(PoolBall, FirstEightAreSolid)
{
    for (int number = 1; number <= 8; ++number) {
        Image const image = ball(number);
        EXPECT_FALSE(is_white(image.getPixel(0, height / 2))) << number;
        EXPECT_EQ(image.getPixel(0, 0), image.getPixel(0, height / 2)) << number;
        EXPECT_EQ(image.getPixel(500, height - 1), image.getPixel(0, height / 2)) << number;
    }
}

TEST(PoolBall, OthersAreWhiteWithAStripeOfTheSameColour)
{
    for (int number = 9; number <= 15; ++number) {
        Image const image = ball(number);
        EXPECT_TRUE(is_white(image.getPixel(0, 0))) << number;
        EXPECT_TRUE(is_white(image.getPixel(0, height - 1))) << number;
        EXPECT_EQ(image.getPixel(0, height / 2), ball(number - 8).getPixel(0, height / 2)) << number;
    }
}

TEST(PoolBall, DiscIsRoundOnTheBall)
{
    Image const image = ball(3);
    for (int i = 0; i < 32; ++i) {
        float const direction = float(i) / 32.f * glm::two_pi<float>();
        EXPECT_TRUE(is_white(around_disc(image, 0.40f, direction))) << i;
        EXPECT_FALSE(is_white(around_disc(image, 0.44f, direction))) << i;
    }
}

TEST(PoolBall, BothSidesHaveTheSameNumber)
{
    Image const image = ball(14);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width / 2; ++x)
            ASSERT_EQ(image.getPixel(x, y), image.getPixel(x + width / 2, y));
}

TEST(PoolBall, SeamIsAsSmoothAsTheRest)
{
    EXPECT_EQ(step_after_column(ball(11), width - 1), 0.f);
}
