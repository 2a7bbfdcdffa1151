#include "checks/shapes.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Shape const ball = make_sphere({0, 0, 0}, 2, 1);
Shape const ground = make_plane({0, 1, 0}, {0, 1, 0}, {1, 0, 0}, 2);
Shape const window = make_quad({0, 0, 0}, {2, 0, 0}, {0, 4, 0});

constexpr double half = 0.70710678118654752440;
}  // namespace

TEST(MeetSphere, FindsTheNearSide)
{
    auto const hit = meet(ball, {{0, 0, 5}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 3);
    EXPECT_EQ(hit->position, glm::dvec3(0, 0, 2));
    EXPECT_EQ(hit->normal, glm::dvec3(0, 0, 1));
    EXPECT_EQ(hit->cosine, 1);
}

TEST(MeetSphere, FindsTheFarSideFromInside)
{
    auto const hit = meet(ball, {{0, 0, 1}, {0, 0, 1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 1);
    EXPECT_EQ(hit->normal, glm::dvec3(0, 0, 1)) << "outward";
}

TEST(MeetSphere, MissesBesideAndBehind)
{
    EXPECT_FALSE(meet(ball, {{2.01, 0, 5}, {0, 0, -1}}));
    EXPECT_FALSE(meet(ball, {{0, 0, 5}, {0, 0, 1}}));
}

TEST(MeetPlane, MeasuresAlongTheRay)
{
    auto const hit = meet(ground, {{0, 3, 0}, {half, -half, 0}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 2 / half, 1e-12);
    EXPECT_NEAR(hit->position.x, 2, 1e-12);
    EXPECT_NEAR(hit->cosine, half, 1e-12);
}

TEST(MeetPlane, IsMetFromBelowToo)
{
    EXPECT_TRUE(meet(ground, {{0, 0, 0}, {0, 1, 0}}));
}

TEST(MeetPlane, MissesParallelAndBehind)
{
    EXPECT_FALSE(meet(ground, {{0, 3, 0}, {1, 0, 0}}));
    EXPECT_FALSE(meet(ground, {{0, 1, 0}, {1, 0, 0}})) << "in the plane";
    EXPECT_FALSE(meet(ground, {{0, 3, 0}, {0, 1, 0}}));
}

TEST(MeetQuad, ReachesHalfAnEdgeEitherWay)
{
    EXPECT_TRUE(meet(window, {{0.9, 1.9, 5}, {0, 0, -1}}));
    EXPECT_TRUE(meet(window, {{-0.9, -1.9, 5}, {0, 0, -1}}));
    EXPECT_FALSE(meet(window, {{1.1, 0, 5}, {0, 0, -1}}));
    EXPECT_FALSE(meet(window, {{0, 2.1, 5}, {0, 0, -1}}));
}

TEST(MapUv, MeasuresAPlaneInItsScale)
{
    // bitangent = tangent x normal = (0, 0, 1)
    EXPECT_EQ(map_uv(ground, {3, 1, -5}), glm::dvec2(1.5, -2.5));
}

TEST(MapUv, GoesAroundASphere)
{
    EXPECT_NEAR(map_uv(ball, {2, 0, 0}).x, 0, 1e-12);
    EXPECT_NEAR(map_uv(ball, {0, 0, -2}).x, 0.25, 1e-12);
    EXPECT_NEAR(map_uv(ball, {-2, 0, -1e-9}).x, 0.5, 1e-9);
    EXPECT_NEAR(map_uv(ball, {0, 0, 2}).x, 0.75, 1e-12);
}

TEST(MapUv, GoesFromPoleToPole)
{
    EXPECT_NEAR(map_uv(ball, {0, -2, 0}).y, 0, 1e-12);
    EXPECT_NEAR(map_uv(ball, {2, 0, 0}).y, 0.5, 1e-12);
    EXPECT_NEAR(map_uv(ball, {0, 2, 0}).y, 1, 1e-12);
    EXPECT_NEAR(map_uv(make_sphere({0, 0, 0}, 2, 5), {2, 0, 0}).y, 2.5, 1e-12);
}
}  // namespace testat
