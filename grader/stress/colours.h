#pragma once
#include "checks/textures.h"
#include "stress/numbers.h"

/// Textures of all shapes and colours.
namespace testat {
/// Powers of two: square, 2:1, 1:8, rows and columns; up to `side` long, and `area` texels in all.
glm::ivec2 power_of_two_size(Random& random, int side, int area);

/// Finite, below 1e30: even noise, signed, many orders of magnitude in one texture, or one colour. Uses `random` as
/// long as it lives.
Colour any_colour(Random& random);
}  // namespace testat
