#include "room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {
int const floor_material = 1;
int const box_material = 2;

/// A floor at y = -1 and a ceiling at y = 2.
Room empty_room()
{
    Room room = {};
    room.walls = {{{0.f, 1.f, 0.f}, 1.f, floor_material}, {{0.f, -1.f, 0.f}, 2.f, floor_material}};
    return room;
}

BlockList all_blocks(Room const& room)
{
    BlockList blocks(room.blocks.size());
    std::iota(blocks.begin(), blocks.end(), 0);
    return blocks;
}

Hit look(Room const& room, glm::vec3 const& direction)
{
    return trace(room, all_blocks(room), glm::vec3(0.f), glm::normalize(direction));
}
}  // namespace

TEST(Room, RaysMeetWalls)
{
    Hit const hit = look(empty_room(), {1.f, -1.f, 0.f});
    EXPECT_EQ(hit.material, floor_material);
    EXPECT_NEAR(hit.t, std::sqrt(2.f), 1e-5f);
    EXPECT_EQ(hit.normal, glm::vec3(0.f, 1.f, 0.f));
}

TEST(Room, RaysMeetTheNearerBox)
{
    Room room = empty_room();
    add_box(room, {4.f, -1.f, -1.f}, {5.f, 1.f, 1.f}, 3);
    add_box(room, {2.f, -1.f, -1.f}, {3.f, 1.f, 1.f}, box_material);
    Hit const hit = look(room, {1.f, 0.01f, 0.01f});
    EXPECT_EQ(hit.material, box_material);
    EXPECT_NEAR(hit.position.x, 2.f, 1e-5f);
    EXPECT_EQ(hit.normal, glm::vec3(-1.f, 0.f, 0.f));
}

TEST(Room, CutBoxesHaveNoGaps)
{
    Room room = empty_room();
    add_box(room, {2.f, -0.5f, -10.f}, {2.5f, 0.5f, 10.f}, box_material);
    EXPECT_GT(room.blocks.size(), 4u);
    for (float z = -9.5f; z < 9.5f; z += 0.37f)
        EXPECT_EQ(look(room, {2.f, 0.03f, z}).material, box_material) << z;
}

TEST(Room, BarsAreTurned)
{
    Room room = empty_room();
    add_bar(room, {-1.f, -0.5f, 3.f}, {1.f, 1.5f, 3.f}, 0.1f, box_material);
    EXPECT_EQ(look(room, {0.01f, 0.5f, 3.f}).material, box_material);
    EXPECT_EQ(look(room, {0.81f, 1.3f, 3.f}).material, box_material);
    EXPECT_EQ(look(room, {0.81f, -0.3f, 3.f}).material, floor_material);
}

TEST(Room, FreeDistanceIsToTheNearestThing)
{
    Room room = empty_room();
    EXPECT_FLOAT_EQ(free_distance(room, {}, {0.f, 0.25f, 0.f}), 1.25f);
    add_box(room, {0.5f, 0.f, -1.f}, {1.f, 1.f, 1.f}, box_material);
    EXPECT_FLOAT_EQ(free_distance(room, all_blocks(room), {0.f, 0.25f, 0.f}), 0.5f);
}

TEST(Room, CornersAreDarker)
{
    Room room = empty_room();
    room.light_from_above = glm::vec3(1.f);
    Hit const open = look(room, {1.f, -1.f, 0.f});
    float const light_before = arriving_light(room, {}, open).r;
    add_box(room, {1.1f, -1.f, -1.f}, {2.f, 1.f, 1.f}, box_material);
    EXPECT_FLOAT_EQ(light_before, 1.f);
    EXPECT_LT(arriving_light(room, all_blocks(room), open).r, 0.9f);
}
