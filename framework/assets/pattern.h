#pragma once

#include <glm/glm.hpp>

#include <cstdint>

// Patterns on the surfaces of a room, each blurred to what a texel of extent `footprint` shows. All in metres.

/// 1 where a pattern of this period can still be seen, 0 where it would only shimmer.
float visible(float period, float footprint);

/// Ribs of a sheet, or folds of a curtain: shading around 1, smooth, with a period.
float ribs(float position, float period, float strength, float footprint);

/// 1 in lines of a width that repeat with a period, around position 0.
float lines(float position, float period, float line_width, float footprint);

/// 1 where low < position < high.
float between(float low, float high, float position, float footprint);

/// 1 in a rectangle.
float in_rectangle(glm::vec2 const& low, glm::vec2 const& high, glm::vec2 const& position, float footprint);

/// Noise around 0, between -0.5 and 0.5, of features about as large as size.
float mottle(glm::vec2 const& position, float size, std::uint32_t seed);
