#pragma once

#include "room.h"

// What is where in the living room, and what it is made of. The windows look along -z, the door is at -x.

/// Materials of the room.
enum FlatMaterial {
    flat_floor,
    flat_glass,
    flat_wall,
    flat_ceiling,
    flat_white,
    flat_curtain,
    flat_radiator,
    flat_door,
    flat_metal,
    flat_oak,
    flat_book,
    flat_sofa,
    flat_pillow,
    flat_frame,
    flat_painting,
    flat_shade,
    flat_plant,
    flat_pot,
    flat_screen
};

float const flat_floor_y = -1.4f;
float const flat_ceiling_y = 1.3f;
float const flat_half_width = 3.2f;
float const flat_half_depth = 2.8f;
/// The plane of the window panes is outside the wall.
float const flat_glass_z = -3.05f;
float const flat_sill_y = -0.55f;
float const flat_lintel_y = 0.95f;
/// The windows are this wide, around these x.
float const flat_window_half_width = 0.75f;
float const flat_windows_x[] = {-1.45f, 1.25f};
/// Front of the paintings on the wall at +x.
float const flat_paintings_x = 3.15f;

/// All the wood in the room.
glm::vec3 const flat_oak_color(0.50f, 0.33f, 0.18f);

/// All that stands in the room, or hangs on its walls, and the light of its lamps.
void add_furniture(Room& room);

/// How a place in the room looks.
Surface flat_surface(Hit const& hit);

/// The same, for all but floor, walls, ceiling, door and windows.
Surface furniture_surface(Hit const& hit);

/// The light that comes from a direction outside: sky, houses, and trees in front of them.
glm::vec3 outside_flat(glm::vec3 const& direction);

/// How much of the sun comes through the windows towards a place.
float sun_in_flat(glm::vec3 const& position);

/// Unit.
glm::vec3 sun_over_flat();
