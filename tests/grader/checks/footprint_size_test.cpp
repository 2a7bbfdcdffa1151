#include "checks/footprint_size.h"

#include "checks/shapes.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
/// A pixel of a plane with y = 0, seen from two units above (x, z): corners at +-half in x and z.
FootprintQuestion from_above(glm::dvec3 position, double half, double scale_uv = 1)
{
    FootprintQuestion q{};
    q.shape = make_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, scale_uv);
    store(position, q.position);
    store(glm::dvec3(0, 1, 0), q.normal);
    store(map_uv(q.shape, position), q.uv);
    double const signs[4][2] = {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}};
    for (int i = 0; i < 4; ++i) {
        store(position + glm::dvec3(0, 2, 0), q.origin[i]);
        store(glm::dvec3(signs[i][0] * half, -2, signs[i][1] * half), q.direction[i]);
    }
    return q;
}
}  // namespace

TEST(FootprintSize, IsTheBoxOfTheCorners)
{
    Footprint const size = footprint(from_above({3, 0, 5}, 0.25), {});
    EXPECT_NEAR(size.size.x, 0.5, 1e-6);
    EXPECT_NEAR(size.size.y, 0.5, 1e-6);
    EXPECT_TRUE(size.decided);
}

TEST(FootprintSize, HasABoundOfAFewRoundings)
{
    Footprint const size = footprint(from_above({3, 0, 5}, 0.25), {});
    EXPECT_GT(size.bound.x, 8 * eps * 5);
    EXPECT_LT(size.bound.x, 1000 * eps * 5);
}

TEST(FootprintSize, HasABoundThatGrowsTowardsTheHorizon)
{
    FootprintQuestion flat = from_above({3, 0, 5}, 0.25);
    store(glm::dvec3(1, -1e-3, 0), flat.direction[1]);
    FootprintQuestion flatter = flat;
    store(glm::dvec3(1, -1e-4, 0), flatter.direction[1]);
    EXPECT_GT(footprint(flat, {}).bound.x, 100 * footprint(from_above({3, 0, 5}, 0.25), {}).bound.x);
    EXPECT_GT(footprint(flatter, {}).bound.x, 10 * footprint(flat, {}).bound.x);
}

TEST(FootprintSize, IsUndecidedWhereARayIsNearlyParallel)
{
    FootprintQuestion q = from_above({3, 0, 5}, 0.25);
    store(glm::dvec3(1, -1e-8, 0), q.direction[1]);
    EXPECT_FALSE(footprint(q, {}).decided);
    store(glm::dvec3(1, 0, 0), q.direction[1]);
    EXPECT_TRUE(footprint(q, {}).decided);
}

/// Numbers that float has exactly: the corner that misses lies where the intersection does, so no seam is mended.
TEST(FootprintSize, KeepsACornerThatMissesAtTheIntersection)
{
    FootprintQuestion q = from_above({3, 0, 5}, 0.25);
    store(glm::dvec3(0, 1, 0), q.direction[0]);
    EXPECT_NEAR(footprint(q, {0.5, 0.5}).size.x, 0.5, 1e-6);
    EXPECT_NEAR(footprint(q, {0.25, 0.5}).size.x, 0.5, 1e-6);
}

/// With roundings the offset of the corner that misses has any sign, and with it the framework sees a seam or none.
TEST(FootprintSize, AllowsBothWhereRoundingsDecideAboutASeam)
{
    FootprintQuestion q = from_above({1.1, 0, 1.3}, 0.25, 0.7);
    for (int i : {0, 2})
        store(glm::dvec3(0, 1, 0), q.direction[i]);
    double const half = 0.25 / 0.7;
    EXPECT_NEAR(footprint(q, {half, half}).size.x, half, 1e-5);
    EXPECT_NEAR(footprint(q, {0, half}).size.x, 0, 1e-5);
    EXPECT_NEAR(footprint(q, {half / 2, half}).bound.x, 0, 1e-4);
}
}  // namespace testat
