#pragma once
#include "checks/vectors.h"
#include "protocol/questions.h"

#include <optional>

/// Oracles in double for the framework's shapes and texture mappings (FRAMEWORK.md, section 1).
namespace testat {
struct Line {
    glm::dvec3 origin;
    glm::dvec3 direction;  ///< unit
};

/// What a ray meets first.
struct Hit {
    double t;
    glm::dvec3 position;
    glm::dvec3 normal;  ///< unit; outward on a sphere
    double cosine;      ///< of the angle between ray and normal, absolute
};

/// Smallest t > 0, if any. Questions keep away from rays that only touch a shape.
std::optional<Hit> meet(Shape const& shape, Line const& ray);

/// t of the ray on a plane through `point`; nothing if it is parallel or behind.
std::optional<double> meet_plane(glm::dvec3 point, glm::dvec3 normal, Line const& ray);

/// Texture coordinates of a position on a plane or sphere.
glm::dvec2 map_uv(Shape const& shape, glm::dvec3 position);

Shape make_sphere(glm::dvec3 center, double radius, double scale_uv);
Shape make_plane(glm::dvec3 center, glm::dvec3 normal, glm::dvec3 tangent, double scale_uv);
/// A parallelogram around `center`.
Shape make_quad(glm::dvec3 center, glm::dvec3 e0, glm::dvec3 e1);
}  // namespace testat
