#pragma once

#include <glm/glm.hpp>

/// Meets the ray origin + t * direction with a sphere. The direction need not be unit.
/// True if it is hit; then *t is the smallest solution >= 0: from inside, that is the far one.
bool intersect_sphere(glm::vec3 const& origin, glm::vec3 const& direction, glm::vec3 const& center, float radius,
                      float* t);

/// Meets the ray origin + t * direction with the plane through center, from either side.
/// A direction exactly parallel to the plane: false, *t is untouched.
/// Otherwise *t is where the line meets the plane, and the result is true if that is ahead (*t > 0).
bool intersect_plane(glm::vec3 const& origin, glm::vec3 const& direction, glm::vec3 const& center,
                     glm::vec3 const& normal, float* t);
