#pragma once

#include <cglib/rt/prepared_render.h>

#include <vector>

namespace viewer {

/// The tiles of a picture, side x side pixels or what is left at its border, from the centre outward.
std::vector<Tile> tiles_from_centre(int width, int height, int side);

}  // namespace viewer
