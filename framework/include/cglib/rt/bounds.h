#pragma once

#include <glm/glm.hpp>

#include <cfloat>

/// An axis-aligned box that contains all of something. Without a bound along an axis it reaches from -FLT_MAX to
/// FLT_MAX there.
struct Bounds {
    glm::vec3 lower = glm::vec3(-FLT_MAX);
    glm::vec3 upper = glm::vec3(FLT_MAX);

    /// False if any side is missing.
    bool is_finite() const;

    /// The smallest box around two.
    static Bounds around(Bounds const& a, Bounds const& b);
    /// The smallest box around points, count >= 1.
    static Bounds around(glm::vec3 const* points, int count);
};
