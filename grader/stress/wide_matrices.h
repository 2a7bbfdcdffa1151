#pragma once
#include "checks/matrices.h"
#include "stress/numbers.h"

/// Matrices and vectors of many orders of magnitude.
namespace testat {
constexpr double smallest_scale = 1e-12;
constexpr double largest_scale = 1e12;

/// The linear part of a transformation, invertible, of scale about 1: a rotation, or one that keeps axes parallel, with
/// a scale of its own for each axis, mirrored, sheared, or nearly singular (factors down to 1 / `flattest`).
glm::dmat4 any_shape_of_space(Random& random, double flattest);

/// A direction of length 1: anywhere, along an axis, or nearly so.
glm::dvec3 any_direction(Random& random);

/// Replaces one to three of `size` numbers by NaN, infinity, or what float can hardly hold.
void spoil(Random& random, float* numbers, int size);
}  // namespace testat
