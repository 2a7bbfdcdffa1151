#pragma once
#include "checks/random.h"
#include "checks/vectors.h"

namespace testat {
/// Uniform on the unit sphere.
glm::dvec3 random_direction(Random& random);

/// A rotation about a random axis by a random angle.
glm::dmat4 random_rotation(Random& random);

/// Each component in [-extent, extent).
glm::dvec3 random_vector(Random& random, double extent);

/// Factors in [1/4, 4), each axis its own.
glm::dvec3 random_scale(Random& random);
}  // namespace testat
