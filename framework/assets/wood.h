#pragma once

#include <glm/glm.hpp>

#include <cstdint>

/// How a point of a board looks.
struct WoodPoint {
    /// 0 just after a ring of the tree ends, growing to 1 at the dark end of the next.
    float ring;
    /// Lighter and darker streaks along the grain, 0 to 1.
    float fibre;
    /// Short dark gaps along the grain, 0 to 1.
    float pore;
};

/// How a board was cut. The grain runs along y.
struct WoodCut {
    /// Of the middle of the tree below the board: x, and its depth at y = 0 and at y = 1.
    float middle;
    float depth_low;
    float depth_high;
    float rings_per_unit;
    std::uint32_t seed;
};

/// p in [0, 1]^2 covers a board.
WoodPoint wood_at(WoodCut const& cut, glm::vec2 const& p);

/// Warm and light, as for gamma 2.2.
glm::vec3 wood_color(WoodPoint const& point);
