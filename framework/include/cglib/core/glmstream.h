#pragma once

#include <glm/glm.hpp>

// Submissions that print their vectors expect std::cout to be there.
#include <iostream>

namespace glm {
/// Writes "(x, y)".
std::ostream& operator<<(std::ostream& out, vec2 const& v);
/// Writes "(x, y, z)".
std::ostream& operator<<(std::ostream& out, vec3 const& v);
/// Writes "(x, y, z, w)".
std::ostream& operator<<(std::ostream& out, vec4 const& v);
/// Writes the three rows, each as a vector, separated by line ends.
std::ostream& operator<<(std::ostream& out, mat3 const& m);
/// Writes the four rows, each as a vector, separated by line ends.
std::ostream& operator<<(std::ostream& out, mat4 const& m);
}  // namespace glm
