#include <cglib/rt/intersection_tests.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {
glm::vec3 const origin(0.f);
glm::vec3 const up(0.f, 1.f, 0.f);
glm::vec3 const forward(0.f, 0.f, -1.f);
float const untouched = -42.f;
}  // namespace

TEST(IntersectSphere, FromOutsideIsTheNearRoot)
{
    float t;
    ASSERT_TRUE(intersect_sphere(origin, forward, glm::vec3(0.f, 0.f, -5.f), 2.f, &t));
    EXPECT_EQ(t, 3.f);
}

TEST(IntersectSphere, FromInsideIsTheFarRoot)
{
    float t;
    ASSERT_TRUE(intersect_sphere(origin, forward, glm::vec3(0.f, 0.f, -1.f), 2.f, &t));
    EXPECT_EQ(t, 3.f);
}

TEST(IntersectSphere, DirectionNeedNotBeUnit)
{
    float t;
    ASSERT_TRUE(intersect_sphere(origin, 2.f * forward, glm::vec3(0.f, 0.f, -5.f), 2.f, &t));
    EXPECT_EQ(t, 1.5f);
}

TEST(IntersectSphere, BehindAndBesideIsMissed)
{
    float t = untouched;
    EXPECT_FALSE(intersect_sphere(origin, forward, glm::vec3(0.f, 0.f, 5.f), 2.f, &t));
    EXPECT_FALSE(intersect_sphere(origin, forward, glm::vec3(2.1f, 0.f, -5.f), 2.f, &t));
    EXPECT_EQ(t, untouched);
}

TEST(IntersectSphere, SmallAndFarIsHitOnItsSurface)
{
    float t;
    glm::vec3 const center(0.f, 0.f, -10000.f);
    ASSERT_TRUE(intersect_sphere(origin, forward, center, 0.5f, &t));
    EXPECT_NEAR(t, 9999.5f, 1e-3f);
}

TEST(IntersectSphere, DegenerateInputIsMissed)
{
    float t;
    EXPECT_FALSE(intersect_sphere(origin, glm::vec3(0.f), glm::vec3(0.f, 0.f, -5.f), 2.f, &t));
    EXPECT_FALSE(intersect_sphere(origin, glm::vec3(std::nanf("")), glm::vec3(0.f, 0.f, -5.f), 2.f, &t));
}

TEST(IntersectPlane, AheadIsHit)
{
    float t;
    ASSERT_TRUE(intersect_plane(origin, 2.f * up, glm::vec3(7.f, 4.f, 0.f), up, &t));
    EXPECT_EQ(t, 2.f);
}

TEST(IntersectPlane, BehindIsMissedButWritten)
{
    float t = untouched;
    EXPECT_FALSE(intersect_plane(origin, up, glm::vec3(0.f, -4.f, 0.f), up, &t));
    EXPECT_EQ(t, -4.f);
}

TEST(IntersectPlane, StartOnThePlaneIsMissed)
{
    float t = untouched;
    EXPECT_FALSE(intersect_plane(origin, up, origin, up, &t));
    EXPECT_EQ(t, 0.f);
}

TEST(IntersectPlane, ParallelLeavesTUntouched)
{
    float t = untouched;
    EXPECT_FALSE(intersect_plane(origin, forward, glm::vec3(0.f, 4.f, 0.f), up, &t));
    EXPECT_EQ(t, untouched);
}

TEST(IntersectPlane, BackFaceIsHit)
{
    float t;
    EXPECT_TRUE(intersect_plane(origin, up, glm::vec3(0.f, 4.f, 0.f), up, &t));
    EXPECT_TRUE(intersect_plane(origin, up, glm::vec3(0.f, 4.f, 0.f), -up, &t));
}
