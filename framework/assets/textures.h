#pragma once

#include <cglib/core/image.h>

// The textures of the scenes. Each function makes the same bytes on every run, whatever the number of processors.
// Values are those of an 8-bit file, v/255, to be saved with gamma 1. Row 0 is the bottom.

/// A marbled checkerboard of 128 x 128 texels and 8 x 8 fields, tileable, without symmetry. The same bytes on every
/// machine, too: only + - * / sqrt and floor, whose results IEEE 754 fixes, and integer hashes.
Image make_checker();

/// A wall of rough stones, 1024 x 1024, tileable. As for gamma 2.2.
Image make_stonewall_diffuse();
/// Its normals, see make_normal_map; for spheres: their bitangent points along falling v.
Image make_stonewall_normal();

/// A floor of concrete slabs, 512 x 512, tileable. As for gamma 2.2.
Image make_concrete_diffuse();
/// Its normals, see make_normal_map; for planes.
Image make_concrete_normal();

/// A wooden board of 19 x 19 lines, 2048 x 2048: line i is at 0.5 + (i - 9) * 0.0478515625 of the picture's width and
/// height. As for gamma 2.2.
Image make_go_board_diffuse();
/// The normals of its grain and its engraved lines, see make_normal_map; for quads.
Image make_go_board_normal();

/// Ball `number`, 1 to 15 (asserted), longitude by latitude, 1024 x 512, with its number in discs at longitudes 1/4 and
/// 3/4. As for gamma 2.2.
Image make_pool_ball(int number);

/// Green felt, 256 x 256, tileable. As for gamma 2.2.
Image make_pool_table();

/// An industrial hall seen from inside, 2048 x 1024, as for gamma 2. Direction d is at
/// ((atan2(d.z, d.x) + pi) / 2pi, (asin(d.y) + pi/2) / pi) of the picture's width and height.
Image make_warehouse();

/// A living room, like make_warehouse.
Image make_apartment();
