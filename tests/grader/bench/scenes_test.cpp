#include "bench/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat::bench {
namespace {
Scene const& scene(std::string const& id)
{
    for (auto const& one : scenes())
        if (one.id == id)
            return one;
    throw std::out_of_range(id);
}

TEST(Scenes, AreThoseOfTheSheet)
{
    std::vector<std::string> ids;
    for (auto const& one : scenes())
        ids.push_back(one.id);
    EXPECT_EQ(ids, (std::vector<std::string>{"plane_0", "plane_30", "plane_45", "sphere", "goboard"}));
}

TEST(Scenes, FillMuchOfThePictureWithFiniteFootprints)
{
    for (auto const& one : scenes()) {
        View const view = look_at(one, 32);
        EXPECT_GT(view.pixels.size(), 32u * 32u / 6) << one.id;
        ASSERT_EQ(view.pixels.size(), view.footprints.size());
        for (auto const& f : view.footprints) {
            for (glm::vec2 const v : {f.uv, f.dx, f.dy, f.dudv})
                EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y)) << one.id;
            EXPECT_TRUE(f.dudv.x > 0 && f.dudv.y > 0) << one.id;
        }
    }
}

/// The box is that of the parallelogram where the surface is nearly flat, as near to the camera.
TEST(Scenes, HaveBoxesAroundTheirParallelograms)
{
    View const view = look_at(scene("plane_30"), 64);
    Footprint const& nearest = view.footprints.front();
    glm::vec2 const box = glm::abs(nearest.dx) + glm::abs(nearest.dy);
    EXPECT_NEAR(nearest.dudv.x, box.x, 0.05 * box.x);
    EXPECT_NEAR(nearest.dudv.y, box.y, 0.05 * box.y);
}

/// Where u jumps from 5 to 0 no footprint is as large as the jump.
TEST(Scenes, HaveNoFootprintsAcrossTheSeam)
{
    for (auto const& f : look_at(scene("sphere"), 64).footprints)
        EXPECT_LT(f.dudv.x, 4);
}

TEST(Scenes, TurnTheTextureOnly)
{
    View const straight = look_at(scene("plane_0"), 32);
    View const turned = look_at(scene("plane_45"), 32);
    ASSERT_EQ(straight.pixels, turned.pixels);
    for (std::size_t i = 0; i < straight.footprints.size(); ++i)
        EXPECT_NEAR(glm::length(straight.footprints[i].dy), glm::length(turned.footprints[i].dy),
                    1e-4 * glm::length(turned.footprints[i].dy));
}
}  // namespace
}  // namespace testat::bench
