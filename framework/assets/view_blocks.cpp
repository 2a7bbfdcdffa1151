#include "view_blocks.h"

#include <cmath>

namespace {
/// Whether a ball is met by the cone.
bool meets_cone(glm::vec3 const& center, float radius, glm::vec3 const& axis, float cone_angle)
{
    float const distance = glm::length(center);
    if (distance <= radius)
        return true;
    float const angle = std::acos(glm::clamp(glm::dot(center, axis) / distance, -1.f, 1.f));
    return angle <= cone_angle + std::asin(radius / distance);
}
}  // namespace

ViewBlocks find_view_blocks(Room const& room, glm::vec3 const& axis, float cone_angle)
{
    ViewBlocks blocks;
    for (std::size_t i = 0; i < room.blocks.size(); ++i) {
        Block const& block = room.blocks[i];
        float const radius = glm::length(block.half_size);
        if (meets_cone(block.center, radius, axis, cone_angle))
            blocks.seen.push_back(int(i));
        if (meets_cone(block.center, radius + occlusion_range, axis, cone_angle))
            blocks.nearby.push_back(int(i));
    }
    return blocks;
}
