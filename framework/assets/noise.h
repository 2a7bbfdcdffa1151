#pragma once

#include <glm/glm.hpp>

#include <cstdint>

/// A number in [0, 1) that depends on all three integers, and has no pattern in them.
float hash_to_unit(int x, int y, std::uint32_t seed);

/// Noise in [0, 1] that varies smoothly over a distance of 1, and repeats after period >= 1 units in x and in y.
float periodic_noise(glm::vec2 const& p, int period, std::uint32_t seed);

/// Noise of num_octaves octaves in [0, 1], each half as large and half as strong as the one before; the first repeats
/// after period units in x and y, and so does the sum.
float periodic_turbulence(glm::vec2 const& p, int period, int num_octaves, std::uint32_t seed);

/// 0 below low, 1 above high, and 3x^2 - 2x^3 in between; low < high.
float smooth_step(float low, float high, float value);
