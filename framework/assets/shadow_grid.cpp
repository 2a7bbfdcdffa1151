#include "shadow_grid.h"

#include <cmath>

namespace {
int const cells_per_side = 128;
float const cell_size = 0.8f;
}  // namespace

ShadowGrid::ShadowGrid(Room const& room)
    : room_(room),
      right_(glm::normalize(glm::cross(glm::vec3(0.f, 1.f, 0.f), room.sun_direction))),
      up_(glm::cross(room.sun_direction, right_)),
      cells_(cells_per_side * cells_per_side)
{
    for (int i = 0; i < int(room.blocks.size()); ++i)
        add(i);
}

glm::vec2 ShadowGrid::seen_from_sun(glm::vec3 const& position) const
{
    return glm::vec2(glm::dot(position, right_), glm::dot(position, up_));
}

/// What is too far outside is counted to the border.
glm::ivec2 ShadowGrid::cell(glm::vec2 const& seen) const
{
    glm::vec2 const position = seen / cell_size + 0.5f * float(cells_per_side);
    return glm::ivec2(glm::clamp(position, 0.f, float(cells_per_side - 1)));
}

void ShadowGrid::add(int block)
{
    float const radius = glm::length(room_.blocks[std::size_t(block)].half_size);
    glm::vec2 const middle = seen_from_sun(room_.blocks[std::size_t(block)].center);
    glm::ivec2 const low = cell(middle - radius);
    glm::ivec2 const high = cell(middle + radius);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
            cells_[std::size_t(x + y * cells_per_side)].push_back(block);
}

glm::vec3 ShadowGrid::sun_light(Hit const& hit) const
{
    float const arriving = glm::dot(hit.normal, room_.sun_direction);
    float const entering = arriving > 0.f ? room_.sun_enters(hit.position) : 0.f;
    if (entering <= 0.f)
        return glm::vec3(0.f);
    glm::vec3 const origin = hit.position + 0.01f * hit.normal;
    glm::ivec2 const place = cell(seen_from_sun(origin));
    BlockList const& in_the_way = cells_[std::size_t(place.x + place.y * cells_per_side)];
    bool const is_shadowed = trace(room_, in_the_way, origin, room_.sun_direction).face >= 0;
    return is_shadowed ? glm::vec3(0.f) : room_.sun_light * (arriving * entering);
}
