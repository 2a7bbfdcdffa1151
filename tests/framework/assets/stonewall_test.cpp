#include "masonry.h"
#include "texture_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

TEST(Masonry, ContinuesAtTheBorders)
{
    Masonry const masonry(7, 6, 71);
    for (float const along : {0.1f, 0.4f, 0.83f}) {
        EXPECT_NEAR(masonry.find({0.f, along}).border, masonry.find({1.f, along}).border, 1e-4f);
        EXPECT_NEAR(masonry.find({along, 0.f}).border, masonry.find({along, 1.f}).border, 1e-4f);
        EXPECT_EQ(masonry.find({along, 0.f}).stone, masonry.find({along, 1.f}).stone);
    }
}

TEST(Masonry, ShowsAllStones)
{
    Masonry const masonry(7, 6, 71);
    std::set<std::pair<int, int>> stones;
    for (int i = 0; i < 100 * 100; ++i) {
        glm::ivec2 const stone = masonry.find({float(i % 100) / 100.f, float(i / 100) / 100.f}).stone;
        stones.insert({stone.x, stone.y});
    }
    EXPECT_EQ(stones.size(), 42u);
}

/// From the mortar to the middle of a stone it goes up, and the normals lean back: along u, and along falling v, where
/// the bitangent of spheres points.
TEST(Stonewall, StonesStandOutOnSpheres)
{
    Image const normals = texture_file("stonewall_normal");
    Masonry const masonry(7, 6, 71);
    glm::vec2 lean(0.f);
    for (int y = 0; y < 1024; y += 4)
        for (int x = 0; x < 1024; x += 4) {
            StonePoint const point = masonry.find(glm::vec2(float(x), float(y)) / 1024.f);
            glm::vec3 const normal = normal_at(normals, x, y);
            if (point.border < 0.2f)
                lean += glm::vec2(normal.x, normal.z) * glm::normalize(point.offset) / (256.f * 256.f);
        }
    EXPECT_GT(lean.x, 0.03f);
    EXPECT_LT(lean.y, -0.03f);
}
