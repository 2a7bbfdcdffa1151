#include "apartment.h"
#include "panorama.h"
#include "textures.h"

namespace {
void add_walls(Room& room)
{
    room.walls = {{{0.f, 1.f, 0.f}, -flat_floor_y, flat_floor},   {{0.f, -1.f, 0.f}, flat_ceiling_y, flat_ceiling},
                  {{1.f, 0.f, 0.f}, flat_half_width, flat_wall},  {{-1.f, 0.f, 0.f}, flat_half_width, flat_wall},
                  {{0.f, 0.f, -1.f}, flat_half_depth, flat_wall}, {{0.f, 0.f, 1.f}, -flat_glass_z, flat_glass}};
}

/// The part of the window wall between two x; sill and lintel leave the windows open.
void add_window_wall(Room& room)
{
    float const inner = -flat_half_depth;
    float x = -flat_half_width;
    for (float const window : flat_windows_x) {
        float const left = window - flat_window_half_width;
        float const right = window + flat_window_half_width;
        add_box(room, {x, flat_floor_y, flat_glass_z}, {left, flat_ceiling_y, inner}, flat_wall);
        add_box(room, {left, flat_floor_y, flat_glass_z}, {right, flat_sill_y, inner}, flat_wall);
        add_box(room, {left, flat_lintel_y, flat_glass_z}, {right, flat_ceiling_y, inner}, flat_wall);
        x = right;
    }
    add_box(room, {x, flat_floor_y, flat_glass_z}, {flat_half_width, flat_ceiling_y, inner}, flat_wall);
}

void add_window_frame(Room& room, float window)
{
    float const half = flat_window_half_width;
    float const z = flat_glass_z;
    for (float const x : {-half + 0.035f, 0.f, half - 0.035f})
        add_box(room, {window + x - 0.035f, flat_sill_y, z}, {window + x + 0.035f, flat_lintel_y, z + 0.06f},
                flat_white);
    for (float const y : {flat_sill_y + 0.035f, 0.45f, flat_lintel_y - 0.035f})
        add_box(room, {window - half, y - 0.035f, z}, {window + half, y + 0.035f, z + 0.05f}, flat_white);
    add_box(room, {window - half - 0.06f, flat_sill_y - 0.04f, z}, {window + half + 0.06f, flat_sill_y, -2.66f},
            flat_white, 0.01f);
}

void add_curtains(Room& room, float window)
{
    float const half = flat_window_half_width;
    for (float const side : {-1.f, 1.f}) {
        float const middle = window + side * (half + 0.13f);
        add_box(room, {middle - 0.2f, flat_floor_y + 0.03f, -2.66f}, {middle + 0.2f, 1.12f, -2.58f}, flat_curtain);
    }
    add_box(room, {window - half - 0.42f, 1.11f, -2.64f}, {window + half + 0.42f, 1.14f, -2.61f}, flat_metal);
    add_box(room, {window - 0.5f, flat_floor_y + 0.12f, -2.79f}, {window + 0.5f, flat_floor_y + 0.66f, -2.7f},
            flat_radiator, 0.01f);
}

void add_door(Room& room)
{
    float const wall = -flat_half_width;
    float const top = flat_floor_y + 2.05f;
    for (float const z : {0.42f, 1.40f})
        add_box(room, {wall, flat_floor_y, z - 0.06f}, {wall + 0.05f, top, z + 0.06f}, flat_white);
    add_box(room, {wall, top, 0.36f}, {wall + 0.05f, top + 0.1f, 1.46f}, flat_white);
    add_box(room, {wall, flat_floor_y, 0.48f}, {wall + 0.025f, top, 1.34f}, flat_door);
    add_box(room, {wall + 0.06f, flat_floor_y + 1.02f, 0.53f}, {wall + 0.08f, flat_floor_y + 1.05f, 0.66f}, flat_metal);
    add_box(room, {wall, flat_floor_y + 0.95f, 0.53f}, {wall + 0.035f, flat_floor_y + 1.12f, 0.565f}, flat_metal);
}

/// What the sky sends through the windows, and what the sunlit floor sends up.
void add_daylight(Room& room)
{
    for (float const x : flat_windows_x) {
        room.lamps.push_back({{x, 0.2f, -2.75f}, {0.f, -0.3f, 0.954f}, glm::vec3(2.6f, 2.75f, 2.9f)});
        room.lamps.push_back(
            {{x + 0.7f, flat_floor_y + 0.02f, -0.9f}, {0.f, 1.f, 0.f}, glm::vec3(0.95f, 0.72f, 0.48f)});
    }
}

Room make_flat()
{
    Room room = {};
    add_walls(room);
    add_window_wall(room);
    for (float const x : flat_windows_x) {
        add_window_frame(room, x);
        add_curtains(room, x);
    }
    add_door(room);
    add_furniture(room);
    add_daylight(room);
    room.light_from_above = glm::vec3(0.50f, 0.49f, 0.47f);
    room.light_from_below = glm::vec3(0.60f, 0.54f, 0.46f);
    room.sun_direction = sun_over_flat();
    room.sun_light = glm::vec3(3.0f, 2.6f, 2.0f);
    room.surface = &flat_surface;
    room.sun_enters = &sun_in_flat;
    return room;
}
}  // namespace

Image make_apartment()
{
    return make_panorama(make_flat());
}
