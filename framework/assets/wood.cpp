#include "wood.h"

#include "noise.h"

#include <cmath>

namespace {
/// No repetition within a board.
int const period = 4096;

float noise(glm::vec2 const& p, float across, float along, std::uint32_t seed)
{
    return periodic_noise(glm::vec2(across * p.x, along * p.y), period, seed);
}

/// Tree rings are circles around the middle of the tree, which the board cuts lengthwise.
float rings(WoodCut const& cut, glm::vec2 const& p)
{
    float const sway =
        0.07f * (noise(p, 1.5f, 1.7f, cut.seed) - 0.5f) + 0.02f * (noise(p, 7.f, 3.f, cut.seed + 1) - 0.5f);
    float const x = p.x - cut.middle + sway;
    float const depth = glm::mix(cut.depth_low, cut.depth_high, p.y) + 0.10f * noise(p, 0.8f, 2.3f, cut.seed + 2);
    float const ripple = 0.25f * noise(p, 60.f, 6.f, cut.seed + 3);
    return cut.rings_per_unit * std::sqrt(x * x + depth * depth) + ripple;
}

/// Slow growth, then an abrupt end.
float ring_profile(float position)
{
    float const x = position - std::floor(position);
    return x * x * (1.f - smooth_step(0.90f, 1.f, x));
}
}  // namespace

WoodPoint wood_at(WoodCut const& cut, glm::vec2 const& p)
{
    float const position = rings(cut, p);
    float const fibre = 0.6f * noise(p, 260.f, 5.f, cut.seed + 4) + 0.4f * noise(p, 800.f, 14.f, cut.seed + 5);
    float const pore = smooth_step(0.78f, 0.95f, noise(p, 640.f, 20.f, cut.seed + 6));
    return {ring_profile(position), fibre, pore};
}

glm::vec3 wood_color(WoodPoint const& point)
{
    glm::vec3 const early(0.890f, 0.700f, 0.435f);
    glm::vec3 const late(0.715f, 0.455f, 0.215f);
    glm::vec3 const color = glm::mix(early, late, 0.70f * point.ring);
    return color * (0.88f + 0.20f * point.fibre) * (1.f - point.pore * glm::vec3(0.16f, 0.24f, 0.34f));
}
