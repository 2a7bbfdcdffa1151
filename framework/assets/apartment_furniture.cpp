#include "apartment.h"
#include "noise.h"

#include <algorithm>
#include <cmath>

namespace {
float const floor_y = flat_floor_y;

/// Side by side on a board from x to to_x.
void add_books(Room& room, float x, float to_x, float y, std::uint32_t seed)
{
    for (int i = 0; x < to_x - 0.06f; ++i) {
        auto const random = [&](std::uint32_t k) { return hash_to_unit(i, int(100.f * (y + 2.f)), seed + k); };
        float const width = 0.022f + 0.035f * random(0);
        float const height = 0.20f + 0.10f * random(1);
        float const front = 2.53f + 0.04f * random(2);
        if (random(3) > 0.08f)
            add_box(room, {x, y, front}, {x + width, y + height, 2.75f}, flat_book, 0.006f);
        x += width + (random(4) > 0.93f ? 0.15f : 0.003f);
    }
}

void add_bookshelf(Room& room, float left, float right)
{
    float const top = floor_y + 2.1f;
    for (float const x : {left, 0.5f * (left + right), right})
        add_box(room, {x - 0.015f, floor_y, 2.47f}, {x + 0.015f, top, 2.8f}, flat_oak);
    for (int i = 0; i <= 5; ++i) {
        float const y = floor_y + 0.08f + 0.4f * float(i);
        add_box(room, {left, y - 0.025f, 2.48f}, {right, y, 2.8f}, flat_oak);
        if (i == 5)
            continue;
        add_books(room, left + 0.03f, 0.5f * (left + right) - 0.2f * float(i % 2), y, 21);
        add_books(room, 0.5f * (left + right) + 0.03f + 0.25f * float((i + 1) % 2), right, y, 22);
    }
}

/// Along the wall at +x, from z = -1.1 to 1.1.
void add_sofa(Room& room)
{
    float const y = floor_y;
    add_box(room, {2.25f, y + 0.12f, -1.1f}, {3.1f, y + 0.34f, 1.1f}, flat_sofa, 0.03f);
    add_box(room, {2.92f, y + 0.12f, -1.1f}, {3.16f, y + 0.82f, 1.1f}, flat_sofa, 0.06f);
    for (float const side : {-1.f, 1.f}) {
        float const arm = side * 1.1f;
        add_box(room, {2.22f, y + 0.1f, std::min(arm, arm - side * 0.2f)},
                {3.1f, y + 0.6f, std::max(arm, arm - side * 0.2f)}, flat_sofa, 0.06f);
        float const cushion = side * 0.45f;
        add_box(room, {2.2f, y + 0.34f, cushion - 0.44f}, {2.95f, y + 0.48f, cushion + 0.44f}, flat_sofa, 0.05f);
        add_box(room, {2.74f, y + 0.46f, cushion - 0.42f}, {2.95f, y + 0.88f, cushion + 0.42f}, flat_sofa, 0.08f);
        float const pillow = side * 0.62f;
        add_box(room, {2.62f, y + 0.48f, pillow - 0.2f}, {2.76f, y + 0.84f, pillow + 0.2f}, flat_pillow, 0.07f);
        for (float const x : {2.35f, 3.0f})
            add_box(room, {x - 0.03f, y, arm - side * 0.15f - 0.03f},
                    {x + 0.03f, y + 0.12f, arm - side * 0.15f + 0.03f}, flat_oak);
    }
}

void add_painting(Room& room, float low_y, float high_y, float low_z, float high_z)
{
    add_box(room, {flat_paintings_x, low_y, low_z}, {3.2f, high_y, high_z}, flat_painting);
    float const rim = 0.035f;
    for (float const y : {low_y, high_y})
        add_box(room, {3.12f, y - rim, low_z - rim}, {3.2f, y + rim, high_z + rim}, flat_frame);
    for (float const z : {low_z, high_z})
        add_box(room, {3.12f, low_y - rim, z - rim}, {3.2f, high_y + rim, z + rim}, flat_frame);
}

/// A lamp that stands in a corner.
void add_floor_lamp(Room& room, float x, float z)
{
    add_box(room, {x - 0.015f, floor_y, z - 0.015f}, {x + 0.015f, floor_y + 1.5f, z + 0.015f}, flat_metal);
    add_box(room, {x - 0.15f, floor_y, z - 0.15f}, {x + 0.15f, floor_y + 0.03f, z + 0.15f}, flat_metal);
    add_box(room, {x - 0.19f, floor_y + 1.35f, z - 0.19f}, {x + 0.19f, floor_y + 1.72f, z + 0.19f}, flat_shade, 0.05f);
    for (float const up : {-1.f, 1.f})
        room.lamps.push_back({{x, floor_y + 1.53f + 0.2f * up, z}, {0.f, up, 0.f}, glm::vec3(0.85f, 0.62f, 0.36f)});
}

void add_ceiling_lamp(Room& room)
{
    float const y = flat_ceiling_y;
    add_box(room, {1.29f, y - 0.4f, 0.89f}, {1.31f, y, 0.91f}, flat_metal);
    add_box(room, {1.12f, y - 0.62f, 0.72f}, {1.48f, y - 0.4f, 1.08f}, flat_shade, 0.08f);
    room.lamps.push_back({{1.3f, y - 0.65f, 0.9f}, {0.f, -1.f, 0.f}, glm::vec3(0.6f, 0.5f, 0.36f)});
}

/// With a screen on it, at the wall at -x.
void add_sideboard(Room& room)
{
    float const y = floor_y;
    add_box(room, {-3.18f, y + 0.12f, -1.95f}, {-2.75f, y + 0.6f, -0.05f}, flat_oak);
    for (float const z : {-1.85f, -0.15f})
        add_box(room, {-3.1f, y, z - 0.03f}, {-2.85f, y + 0.12f, z + 0.03f}, flat_metal);
    add_box(room, {-3.06f, y + 0.68f, -1.7f}, {-3.02f, y + 1.32f, -0.5f}, flat_screen, 0.01f);
    add_box(room, {-3.1f, y + 0.6f, -1.3f}, {-2.95f, y + 0.69f, -0.9f}, flat_metal);
}

/// Leaves of different sizes on a stem.
void add_plant(Room& room, float x, float z)
{
    add_box(room, {x - 0.17f, floor_y, z - 0.17f}, {x + 0.17f, floor_y + 0.36f, z + 0.17f}, flat_pot, 0.02f);
    for (int i = 0; i < 60; ++i) {
        auto const random = [i](int k) { return hash_to_unit(i, k, 81) - 0.5f; };
        float const up = 0.75f + 0.8f * random(1);
        float const spread = 0.9f * std::sqrt(std::max(1.2f - up, 0.05f));
        glm::vec3 const from(x + 0.3f * spread * random(2), floor_y + up, z + spread * random(3));
        glm::vec3 const reach(0.42f * random(4), 0.12f + 0.16f * random(5), 0.f);
        add_bar(room, from, from + reach, 0.022f, flat_plant);
    }
}
}  // namespace

void add_furniture(Room& room)
{
    add_bookshelf(room, -1.9f, 0.3f);
    add_sofa(room);
    add_painting(room, 0.0f, 0.75f, -0.95f, 0.1f);
    add_painting(room, 0.1f, 0.65f, 0.4f, 0.85f);
    add_floor_lamp(room, 2.75f, 1.9f);
    add_ceiling_lamp(room);
    add_sideboard(room);
    add_plant(room, 2.7f, -2.1f);
}
