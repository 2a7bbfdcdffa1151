#pragma once

#include <glm/glm.hpp>

/// The points origin + t * direction, t >= 0.
struct Ray {
    /// From the origin along -z.
    Ray() = default;

    /// The direction is normalised; it must not be zero.
    Ray(glm::vec3 const& ray_origin, glm::vec3 const& ray_direction)
        : origin(ray_origin), direction(glm::normalize(ray_direction))
    {
    }

    glm::vec3 origin = glm::vec3(0.f);
    /// Unit.
    glm::vec3 direction = glm::vec3(0.f, 0.f, -1.f);
};
