#include "room.h"

#include <algorithm>
#include <cmath>

namespace {
/// Keeps the light of a lamp finite next to it, in square metres.
float const lamp_area = 1.5f;

/// 1 in the open, towards 0 in a corner: how much room there is above a place at growing distances.
float openness(Room const& room, BlockList const& nearby, Hit const& hit)
{
    float closed = 0.f;
    for (float const step : {0.06f, 0.2f, 0.5f, occlusion_range}) {
        float const room_there = free_distance(room, nearby, hit.position + step * hit.normal);
        closed += 0.19f * glm::clamp(1.f - room_there / step, 0.f, 1.f);
    }
    return std::max(1.f - closed, 0.f);
}

glm::vec3 lamp_light(Lamp const& lamp, Hit const& hit)
{
    glm::vec3 const way = lamp.position - hit.position;
    float const square = glm::dot(way, way);
    glm::vec3 const direction = way * (1.f / std::sqrt(square));
    // A quarter wrapped around, as lamps and windows are large.
    float const arriving = 0.75f * glm::dot(hit.normal, direction) + 0.25f;
    float const leaving = -0.75f * glm::dot(lamp.direction, direction) + 0.25f;
    return lamp.power * (std::max(arriving, 0.f) * std::max(leaving, 0.f) / (square + lamp_area));
}

}  // namespace

glm::vec3 arriving_light(Room const& room, BlockList const& nearby, Hit const& hit)
{
    glm::vec3 light = glm::mix(room.light_from_below, room.light_from_above, 0.5f + 0.5f * hit.normal.y);
    for (Lamp const& lamp : room.lamps)
        light += lamp_light(lamp, hit);
    return light * openness(room, nearby, hit);
}
