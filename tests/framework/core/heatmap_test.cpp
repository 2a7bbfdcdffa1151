#include <cglib/core/heatmap.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {
glm::vec3 const blue(0.f, 0.f, 1.f);
glm::vec3 const red(1.f, 0.f, 0.f);
}  // namespace

TEST(Heatmap, QuartersHaveTheirColours)
{
    EXPECT_EQ(heatmap(0.f), blue);
    EXPECT_EQ(heatmap(0.25f), glm::vec3(0.f, 1.f, 1.f));
    EXPECT_EQ(heatmap(0.5f), glm::vec3(0.f, 1.f, 0.f));
    EXPECT_EQ(heatmap(0.75f), glm::vec3(1.f, 1.f, 0.f));
    EXPECT_EQ(heatmap(1.f), red);
}

TEST(Heatmap, IsLinearInBetween)
{
    EXPECT_EQ(heatmap(0.125f), glm::vec3(0.f, 0.5f, 1.f));
}

TEST(Heatmap, EveryFloatHasAColour)
{
    float const infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(heatmap(std::nanf("")), blue);
    EXPECT_EQ(heatmap(-infinity), blue);
    EXPECT_EQ(heatmap(infinity), red);
    EXPECT_EQ(heatmap(1e30f), red);
    EXPECT_EQ(heatmap(std::nextafter(1.f, 2.f)), red);
    EXPECT_NEAR(heatmap(std::nextafter(1.f, 0.f)).g, 0.f, 1e-6f);
}
