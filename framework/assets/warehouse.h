#pragma once

#include "room.h"

// What is where in the hall, and what it is made of.

/// Materials of the hall.
enum HallMaterial {
    hall_floor,
    hall_side_wall,
    hall_gate_wall,
    hall_open_wall,
    hall_roof,
    hall_steel,
    hall_column,
    hall_rack,
    hall_board,
    hall_crate,
    hall_plank,
    hall_container_red,
    hall_container_blue,
    hall_lamp
};

float const hall_floor_y = -1.7f;
float const hall_eaves_y = 6.3f;
float const hall_ridge_y = 10.3f;
float const hall_half_width = 12.f;
float const hall_gate_z = -38.f;
float const hall_open_z = 26.f;
/// From one row of columns to the next, the first is at this z, too.
float const hall_bay = 6.f;
float const hall_first_column_z = -34.f;
int const hall_num_columns = 10;

/// Light of the sky.
glm::vec3 const hall_sky(1.55f, 1.75f, 2.0f);
/// Paint of the steel.
glm::vec3 const hall_grey(0.40f, 0.45f, 0.50f);

/// How a place in the hall looks.
Surface hall_surface(Hit const& hit);

/// The same, for walls and roof.
Surface hall_shell_surface(Hit const& hit);

/// Yellow and black stripes across a position.
glm::vec3 hazard(float position, float footprint);

/// 1 in a skylight, at a place of the roof.
float skylight(glm::vec3 const& position, float footprint);

/// How much of the sun comes through the skylights towards a place.
float sun_in_hall(glm::vec3 const& position);

/// Unit.
glm::vec3 sun_over_hall();
