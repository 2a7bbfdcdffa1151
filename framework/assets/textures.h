#pragma once

#include <cglib/core/image.h>

// The textures of the scenes. Each function makes the same bytes on every machine: only + - * / sqrt and floor, whose
// results IEEE 754 fixes, and integer hashes. Values are those of an 8-bit file, v/255, to be saved with gamma 1.

/// A marbled checkerboard of 128 x 128 texels and 8 x 8 fields, tileable, without symmetry.
Image make_checker();
