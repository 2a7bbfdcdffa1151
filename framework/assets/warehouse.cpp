#include "warehouse.h"

#include "noise.h"
#include "panorama.h"
#include "textures.h"

#include <cmath>

namespace {
void add_walls(Room& room)
{
    glm::vec3 const right_roof = glm::normalize(glm::vec3(hall_eaves_y - hall_ridge_y, -hall_half_width, 0.f));
    glm::vec3 const left_roof(-right_roof.x, right_roof.y, 0.f);
    float const roof = -hall_ridge_y * right_roof.y;
    room.walls = {{{0.f, 1.f, 0.f}, -hall_floor_y, hall_floor},
                  {{1.f, 0.f, 0.f}, hall_half_width, hall_side_wall},
                  {{-1.f, 0.f, 0.f}, hall_half_width, hall_side_wall},
                  {{0.f, 0.f, 1.f}, -hall_gate_z, hall_gate_wall},
                  {{0.f, 0.f, -1.f}, hall_open_z, hall_open_wall},
                  {right_roof, roof, hall_roof},
                  {left_roof, roof, hall_roof}};
}

/// Of the roof's lower side at x.
float roof_y(float x)
{
    return hall_ridge_y - 0.25f - (hall_ridge_y - hall_eaves_y) * std::abs(x) / hall_half_width;
}

void add_truss(Room& room, float z)
{
    float const low = hall_eaves_y - 0.5f;
    add_bar(room, {-hall_half_width, low, z}, {hall_half_width, low, z}, 0.12f, hall_steel);
    for (float const side : {-1.f, 1.f}) {
        add_bar(room, {side * hall_half_width, roof_y(hall_half_width), z}, {0.f, roof_y(0.f), z}, 0.12f, hall_steel);
        for (int i = 0; i < 5; ++i) {
            float const x = 2.f * float(i);
            add_bar(room, {side * x, low, z}, {side * x, roof_y(x), z}, 0.06f, hall_steel);
            add_bar(room, {side * (x + 2.f), low, z}, {side * x, roof_y(x), z}, 0.06f, hall_steel);
        }
    }
}

void add_columns(Room& room, float z)
{
    for (float const side : {-1.f, 1.f}) {
        glm::vec3 const foot(side * (hall_half_width - 0.25f), hall_floor_y, z);
        add_box(room, foot - glm::vec3(0.22f, 0.f, 0.22f), foot + glm::vec3(0.22f, 7.9f, 0.22f), hall_column);
    }
}

void add_lamps(Room& room, float z)
{
    for (float const x : {-5.f, 5.f}) {
        glm::vec3 const middle(x, 5.0f, z);
        add_box(room, middle - glm::vec3(0.3f, 0.08f, 0.9f), middle + glm::vec3(0.3f, 0.08f, 0.9f), hall_lamp);
        add_box(room, middle - glm::vec3(0.02f, 0.f, 0.02f), middle + glm::vec3(0.02f, 0.8f, 0.02f), hall_steel);
        room.lamps.push_back({middle + glm::vec3(0.f, 2.f, 0.f), {0.f, -1.f, 0.f}, glm::vec3(7.5f, 7.4f, 7.1f)});
    }
}

/// Crates of different sizes side by side on a shelf.
void add_crates(Room& room, glm::vec3 const& from, float to_z, std::uint32_t seed)
{
    float z = from.z + 0.1f;
    for (int i = 0; z < to_z - 0.8f; ++i) {
        auto const random = [&](std::uint32_t k) { return hash_to_unit(i, int(100.f * from.y), seed + k); };
        glm::vec3 const size(0.8f + 0.3f * random(0), 0.5f + 0.8f * random(1), 0.7f + 0.6f * random(2));
        glm::vec3 const low(from.x + 0.1f * random(3), from.y, z);
        if (random(4) > 0.18f)
            add_box(room, low, low + glm::vec3(size.x, size.y, std::min(size.z, to_z - z - 0.05f)), hall_crate, 0.02f);
        z += size.z + 0.08f + 0.3f * random(5);
    }
}

/// A rack of one depth along z, with its lower left corner at (x, floor, z).
void add_rack(Room& room, float x, float z, float length, std::uint32_t seed)
{
    for (float y : {0.f, 0.2f, 1.95f, 3.7f}) {
        y += hall_floor_y;
        if (y > hall_floor_y + 0.1f)
            add_box(room, {x, y - 0.12f, z}, {x + 1.25f, y, z + length}, hall_board);
        if (y > hall_floor_y + 0.1f)
            add_crates(room, {x + 0.05f, y, z}, z + length, seed);
    }
    for (float along = 0.f; along <= length; along += length / 4.f)
        for (float const depth : {0.f, 1.17f})
            add_box(room, {x + depth, hall_floor_y, z + along - 0.05f},
                    {x + depth + 0.08f, hall_floor_y + 5.2f, z + along + 0.05f}, hall_rack);
}

void add_goods(Room& room)
{
    add_rack(room, -11.2f, -32.f, 11.6f, 11);
    add_rack(room, -11.2f, -19.6f, 11.6f, 12);
    add_rack(room, -11.2f, 4.f, 11.6f, 13);
    add_rack(room, 9.9f, 2.f, 11.6f, 14);
    float const y = hall_floor_y;
    add_box(room, {8.4f, y, -26.f}, {10.8f, y + 2.6f, -20.f}, hall_container_red);
    add_box(room, {8.4f, y, -19.4f}, {10.8f, y + 2.6f, -13.4f}, hall_container_blue);
    add_box(room, {8.5f, y + 2.6f, -22.5f}, {10.9f, y + 5.2f, -16.5f}, hall_container_red);
}

/// A stack of wooden crates as one meets it in the way.
void add_stack(Room& room, glm::vec3 const& foot)
{
    glm::vec3 const size(1.2f, 1.f, 1.2f);
    for (glm::vec3 const& place :
         {glm::vec3(0.f), glm::vec3(1.35f, 0.f, 0.1f), glm::vec3(0.5f, 1.f, 0.f), glm::vec3(0.3f, 0.f, 1.5f)})
        add_box(room, foot + place, foot + place + size, hall_plank, 0.02f);
}

Room make_hall()
{
    Room room = {};
    add_walls(room);
    for (int i = 0; i < hall_num_columns; ++i) {
        float const z = hall_first_column_z + hall_bay * float(i);
        add_truss(room, z);
        add_columns(room, z);
        add_lamps(room, z + 0.5f * hall_bay);
    }
    add_goods(room);
    add_stack(room, {-5.8f, hall_floor_y, -15.f});
    add_stack(room, {5.2f, hall_floor_y, -6.f});
    add_stack(room, {3.5f, hall_floor_y, 14.f});
    room.light_from_above = glm::vec3(0.46f, 0.49f, 0.53f);
    room.light_from_below = glm::vec3(0.26f, 0.255f, 0.245f);
    room.sun_direction = sun_over_hall();
    room.sun_light = glm::vec3(1.5f, 1.35f, 1.1f);
    room.surface = &hall_surface;
    room.sun_enters = &sun_in_hall;
    return room;
}
}  // namespace

Image make_warehouse()
{
    return make_panorama(make_hall());
}
