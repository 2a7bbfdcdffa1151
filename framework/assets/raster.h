#pragma once

#include <cglib/core/image.h>

#include <functional>

/// Calls row(0) ... row(count - 1), each once, on all processors and in any order.
void for_each_row(int count, std::function<void(int)> const& row);

/// An opaque picture; the texel in column x and row y has the colour color(x, y), rounded to what an 8-bit file can
/// hold. Several threads call color.
Image make_image(int width, int height, std::function<glm::vec3(int x, int y)> const& color);

/// The centre of a texel of a picture of width x height; the whole picture is [0, 1]^2.
glm::vec2 texel_center(int x, int y, int width, int height);

/// How much of a texel is covered by what lies signed_distance texels away, negative inside: 0 to 1.
float coverage(float signed_distance);
