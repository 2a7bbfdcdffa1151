#include "checks/matrices.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

namespace testat {
TEST(RandomDirection, HasLengthOne)
{
    Random random(1, "direction");
    for (int i = 0; i < 1000; ++i)
        ASSERT_NEAR(glm::length(random_direction(random)), 1, 1e-15);
}

TEST(RandomRotation, KeepsLengthsAndSide)
{
    Random random(1, "rotation");
    for (int i = 0; i < 100; ++i) {
        glm::dmat3 const r(random_rotation(random));
        ASSERT_NEAR(glm::determinant(r), 1, 1e-12);
        ASSERT_NEAR(glm::length(r * glm::dvec3(1, 2, 3)), std::sqrt(14.0), 1e-12);
    }
}

TEST(RandomScale, IsNeitherTinyNorHuge)
{
    Random random(1, "scale");
    for (int i = 0; i < 1000; ++i) {
        glm::dvec3 const s = random_scale(random);
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(s, glm::dvec3(0.25))));
        ASSERT_TRUE(glm::all(glm::lessThan(s, glm::dvec3(4))));
    }
}
}  // namespace testat
