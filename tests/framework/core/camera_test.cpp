#include <cglib/core/camera.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {
float const tolerance = 1e-5f;

void expect_near(glm::vec3 const& actual, glm::vec3 const& expected)
{
    EXPECT_LT(glm::length(actual - expected), tolerance * (1.f + glm::length(expected)));
}
}  // namespace

TEST(Camera, CentreOfPictureIsStraightAhead)
{
    Camera const camera = Camera::looking_at(glm::vec3(10.f, 7.f, 10.f), glm::vec3(0.f));
    glm::vec3 const ahead = camera.direction(glm::vec2(128.f), 256, 256, 45.f);
    expect_near(glm::normalize(ahead), glm::normalize(glm::vec3(-10.f, -7.f, -10.f)));
}

TEST(Camera, DirectionFollowsTheFormula)
{
    glm::vec3 const direction = Camera().direction(glm::vec2(3.5f, 40.5f), 200, 100, 30.f);
    expect_near(direction, glm::vec3(3.5f - 100.f, 40.5f - 50.f, -100.f / std::tan(0.523598776f)));
}

TEST(Camera, FortyFiveDegreesSeeFiftyThree)
{
    glm::vec3 const top = Camera().direction(glm::vec2(50.f, 100.f), 100, 100, 45.f);
    EXPECT_NEAR(2.f * glm::degrees(std::atan(top.y / -top.z)), 53.13f, 0.01f);
}

TEST(Camera, UpAndRightOfThePictureAreThoseOfTheWorld)
{
    Camera const camera = Camera::looking_along(glm::vec3(0.f), glm::vec3(1.f, 0.f, 0.f));
    expect_near(camera.direction(glm::vec2(60.f, 70.f), 100, 100, 45.f), glm::vec3(100.f, 20.f, 10.f));
}
