#pragma once
#include "checks/shapes.h"

namespace testat {
/// A corner of a pixel's footprint in uv, relative to the intersection's uv, with what float may be off by.
struct Corner {
    glm::dvec2 offset;
    glm::dvec2 error;
};

/// uv at the position, and how much it changes when the position is off by `error` in any direction.
Corner map_corner(FootprintQuestion const& q, glm::dvec3 position, double error);

/// The framework's rule at a seam: where both offsets of a pair point the same way, the longer one is replaced by the
/// mirrored shorter one. Pairs are (0, 1) and (2, 3).
void mend_seams(Corner (&corners)[4]);
}  // namespace testat
