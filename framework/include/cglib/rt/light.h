#pragma once

#include <glm/glm.hpp>

/// A point that shines evenly in all directions.
struct Light {
    /// In world space.
    glm::vec3 position;
    /// rgb; at distance r, power / r^2 arrives.
    glm::vec3 power;
};
