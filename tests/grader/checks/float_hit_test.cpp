#include "checks/float_hit.h"

#include "checks/matrices.h"
#include "checks/shapes.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
RoundedLine rounded(glm::dvec3 origin, glm::dvec3 direction)
{
    float o[3], d[3];
    store(origin, o);
    store(direction, d);
    return {exact_vector(o), normalize(exact_vector(d))};
}

Shape any_shape(Random& random)
{
    glm::dmat3 const frame(random_rotation(random));
    switch (random.integer(0, 2)) {
        case 0:
            return make_sphere(random_vector(random, 2), random.uniform(0.5, 2), 1);
        case 1:
            return make_plane(random_vector(random, 2), frame[1], frame[0], 1);
        default:
            return make_quad(random_vector(random, 2), frame[0] * 2.0, frame[2] * 3.0);
    }
}
}  // namespace

/// Two ways of calculating, of which one is in double only.
TEST(FloatHit, AgreesWithTheGeometry)
{
    Random random(1, "hits");
    int undecided = 0;
    for (int i = 0; i < 20'000; ++i) {
        Shape const shape = any_shape(random);
        RoundedLine const ray = rounded(random_vector(random, 4), random_direction(random));
        FloatHit const hit = meet(shape, ray);
        auto const right = meet(shape, Line{ray.origin.value(), glm::normalize(ray.direction.value())});
        undecided += hit.hit == Certainty::perhaps ? 1 : 0;
        if (hit.hit == Certainty::perhaps)
            continue;
        ASSERT_EQ(hit.hit == Certainty::yes, right.has_value());
        if (!right)
            continue;
        ASSERT_LE(glm::length(hit.position.value() - right->position), 1e-3 * hit.position.error());
        ASSERT_LE(glm::length(hit.normal.value() - right->normal), 1e-3 * hit.normal.error());
    }
    EXPECT_LT(undecided, 20);
}

TEST(FloatHit, IsUndecidedAtTheEdge)
{
    Shape const sphere = make_sphere({0, 0, 0}, 1, 1);
    EXPECT_EQ(meet(sphere, rounded({1, 0, 5}, {0, 0, -1})).hit, Certainty::perhaps);
    EXPECT_EQ(meet(sphere, rounded({0.999, 0, 5}, {0, 0, -1})).hit, Certainty::yes);
    EXPECT_EQ(meet(sphere, rounded({1.001, 0, 5}, {0, 0, -1})).hit, Certainty::no);
    Shape const quad = make_quad({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    EXPECT_EQ(meet(quad, rounded({1, 0, 5}, {0, 0, -1})).hit, Certainty::perhaps);
    EXPECT_EQ(meet(quad, rounded({0.999, 0, 5}, {0, 0, -1})).hit, Certainty::yes);
}

/// On the sphere both solutions may be the first that is ahead.
TEST(FloatHit, IsUndecidedWhereTheRayStartsOnTheShape)
{
    EXPECT_EQ(meet(make_sphere({0, 0, 0}, 1, 1), rounded({0, 0, 1}, {0, 0, -1})).hit, Certainty::perhaps);
    EXPECT_EQ(meet(make_sphere({0, 0, 0}, 1, 1), rounded({0, 0, 0.9}, {0, 0, -1})).hit, Certainty::yes);
}

TEST(FloatHit, IsAMissOnlyIfTheRayIsExactlyParallel)
{
    Shape const plane = make_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 1);
    EXPECT_EQ(meet(plane, rounded({0, 1, 0}, {1, 0, 0})).hit, Certainty::no);
    glm::dvec3 const normal = glm::normalize(glm::dvec3(0.3, 0.9, 0.2));
    Shape const leaning = make_plane({0, 0, 0}, normal, glm::normalize(glm::cross(normal, glm::dvec3(0, 0, 1))), 1);
    EXPECT_EQ(meet(leaning, rounded(normal, glm::cross(normal, glm::dvec3(0, 0, 1)))).hit, Certainty::perhaps);
}
}  // namespace testat
