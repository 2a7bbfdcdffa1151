#pragma once

#include <cglib/core/image.h>

#include <string>

/// The texture that was made at build time, with the values of the file, v/255.
Image texture_file(std::string const& stem);

/// The mean absolute difference of green between columns (rows) x and x + 1, the first following the last.
float step_after_column(Image const& image, int x);
float step_after_row(Image const& image, int y);

/// Whether the steps across both borders are no larger than twice the mean step inside.
bool tiles(Image const& image);

/// Whether all texels of a normal map have unit length, as far as 8 bit can tell, and none points inward.
bool has_unit_normals(Image const& image);

/// The normal of a texel of a normal map: along growing u, away from the surface, along growing v.
glm::vec3 normal_at(Image const& image, int x, int y);
