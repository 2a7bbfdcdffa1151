#pragma once
#include <glm/glm.hpp>

#include <vector>

/// What passes between scenes, filters and errors of `testat bench`.
namespace testat::bench {
/// A pixel's area on a surface, in uv space: what a filter is told.
struct Footprint {
    glm::vec2 uv;    ///< of the pixel's centre; any number of periods away from [0, 1)
    glm::vec2 dx;    ///< how far uv moves from the pixel's left edge to its right one
    glm::vec2 dy;    ///< from its lower edge to its upper one
    glm::vec2 dudv;  ///< size of the box around the four corners, as the sheet's compute_uv_aabb_size gives it
};
using Footprints = std::vector<Footprint>;

/// Linear rgba, one for each footprint.
using Colours = std::vector<glm::vec4>;

/// Linear rgb, one for each footprint.
using Truth = std::vector<glm::dvec3>;
}  // namespace testat::bench
