#include "digits.h"
#include "noise.h"
#include "pattern.h"
#include "warehouse.h"

#include <algorithm>
#include <cmath>

namespace {
/// From the last row of columns.
float along_bay(float z)
{
    float const bay = (z - hall_first_column_z) / hall_bay;
    return hall_bay * (bay - std::floor(bay));
}

glm::vec3 brick(glm::vec2 const& p, float footprint)
{
    float const row = std::floor(p.y / 0.2f);
    float const shift = std::fmod(std::abs(row), 2.f) * 0.2f;
    float const mortar = std::max(lines(p.y, 0.2f, 0.025f, footprint), lines(p.x + shift, 0.4f, 0.025f, footprint));
    float const tone = hash_to_unit(int(std::floor((p.x + shift) / 0.4f)), int(row), 3) - 0.5f;
    glm::vec3 const stone = glm::vec3(0.40f, 0.21f, 0.15f) * (1.f + 0.5f * tone * visible(0.3f, footprint));
    return glm::mix(stone, glm::vec3(0.42f, 0.39f, 0.36f), mortar) * (1.f + 0.5f * mottle(p, 2.5f, 4));
}

/// Brick below, sheet above; p is (along, above the floor).
glm::vec3 wall_color(glm::vec2 const& p, float footprint)
{
    glm::vec3 const sheet = glm::vec3(0.52f, 0.55f, 0.56f) * ribs(p.x, 0.35f, 0.13f, footprint) *
                            (1.f + 0.25f * mottle(glm::vec2(p.x, 0.3f * p.y), 1.5f, 10));
    glm::vec3 const color = glm::mix(sheet, brick(p, footprint), between(-1.f, 2.4f, p.y, footprint));
    return glm::mix(color, glm::vec3(0.24f, 0.26f, 0.28f), between(2.4f, 2.55f, p.y, footprint));
}

/// A wall with a glazed part, in which bars are left standing.
Surface glazed(glm::vec3 const& color, float glass, float bars, float brightness)
{
    float const open = glass * (1.f - bars);
    return {glm::mix(glm::mix(color, glm::vec3(0.14f), glass * bars), glm::vec3(0.f), open),
            hall_sky * (brightness * open)};
}

/// The window under the roof of an end wall.
Surface glazed_gable(glm::vec3 const& color, glm::vec2 const& p, float footprint)
{
    float const glass = in_rectangle({-7.f, 6.6f}, {7.f, 8.6f}, p, footprint);
    float const bars = std::max(lines(p.x, 1.f, 0.08f, footprint), lines(p.y - 6.6f, 1.f, 0.08f, footprint));
    return glazed(color, glass, bars, 0.9f);
}

Surface side_wall_surface(Hit const& hit)
{
    glm::vec2 const p(hit.position.z, hit.position.y - hall_floor_y);
    float const f = hit.footprint;
    float const glass = in_rectangle({0.8f, 5.3f}, {5.2f, 6.9f}, {along_bay(p.x), p.y}, f);
    float const bars = std::max(lines(p.x, 0.95f, 0.06f, f), lines(p.y - 5.3f, 0.8f, 0.06f, f));
    return glazed(wall_color(p, f), glass, bars, 0.85f);
}

glm::vec3 gate_color(glm::vec2 const& p, float footprint)
{
    glm::vec3 const sheet = glm::vec3(0.16f, 0.27f, 0.38f) * ribs(p.y, 0.3f, 0.25f, footprint);
    float const number = stroke_distance(number_strokes(3), (p - glm::vec2(0.f, 2.6f)) / 1.8f, 0.09f) * 1.8f;
    return glm::mix(sheet, glm::vec3(0.75f), glm::clamp(0.5f - number / std::max(footprint, 0.01f), 0.f, 1.f));
}

Surface gate_wall_surface(Hit const& hit)
{
    glm::vec2 const p(hit.position.x, hit.position.y - hall_floor_y);
    float const f = hit.footprint;
    glm::vec3 color = wall_color(p, f);
    color = glm::mix(color, hazard(p.x + p.y, f), in_rectangle({-3.8f, 0.f}, {3.8f, 5.3f}, p, f));
    float const gate = in_rectangle({-3.5f, -1.f}, {3.5f, 5.f}, p, f);
    if (gate > 0.f)
        color = glm::mix(color, gate_color(p, f), gate);
    color = glm::mix(color, glm::vec3(0.12f, 0.30f, 0.18f), in_rectangle({5.5f, 0.f}, {6.6f, 2.2f}, p, f));
    return glazed_gable(color, p, f);
}

/// A yard with trees behind it.
glm::vec3 outside(glm::vec3 const& direction)
{
    float const trees = 0.06f + 0.05f * periodic_turbulence(glm::vec2(30.f * direction.x, 3.f), 4096, 4, 12);
    glm::vec2 const leaf(60.f * direction.x, 60.f * direction.y);
    glm::vec3 const green = glm::vec3(0.20f, 0.30f, 0.12f) * (0.6f + 0.9f * periodic_turbulence(leaf, 4096, 3, 13));
    glm::vec3 const yard = glm::vec3(0.75f, 0.72f, 0.66f);
    glm::vec3 const above = glm::mix(green, hall_sky, smooth_step(trees - 0.004f, trees + 0.004f, direction.y));
    return glm::mix(yard, above, smooth_step(-0.012f, -0.008f, direction.y));
}

Surface open_wall_surface(Hit const& hit)
{
    glm::vec2 const p(hit.position.x, hit.position.y - hall_floor_y);
    float const f = hit.footprint;
    glm::vec3 const frame =
        glm::mix(wall_color(p, f), hazard(p.x + p.y, f), in_rectangle({-4.3f, 0.f}, {4.3f, 5.3f}, p, f));
    float const open = in_rectangle({-4.f, -1.f}, {4.f, 5.f}, p, f);
    if (open > 0.f)
        return {frame * (1.f - open), outside(hit.position / hit.t) * open};
    return glazed_gable(frame, p, f);
}

Surface roof_surface(Hit const& hit)
{
    float const f = hit.footprint;
    float const purlin = lines(std::abs(hit.position.x) - 1.2f, 2.4f, 0.18f, f);
    glm::vec3 const sheet = glm::vec3(0.46f, 0.47f, 0.47f) * ribs(hit.position.z, 0.4f, 0.12f, f);
    float const bars = std::max(lines(hit.position.x, 1.35f, 0.07f, f), lines(hit.position.z - 0.5f, 1.f, 0.07f, f));
    glm::vec3 const color = glm::mix(sheet, 0.5f * hall_grey, purlin);
    return glazed(color, skylight(hit.position, f), std::max(bars, purlin), 1.f);
}
}  // namespace

glm::vec3 hazard(float position, float footprint)
{
    return glm::mix(glm::vec3(0.75f, 0.52f, 0.04f), glm::vec3(0.05f), lines(position, 0.5f, 0.25f, footprint));
}

glm::vec3 sun_over_hall()
{
    return glm::normalize(glm::vec3(0.42f, 0.85f, 0.30f));
}

float skylight(glm::vec3 const& position, float footprint)
{
    return in_rectangle({2.0f, 1.5f}, {7.4f, 4.5f}, {std::abs(position.x), along_bay(position.z)}, footprint);
}

float sun_in_hall(glm::vec3 const& position)
{
    glm::vec3 const sun = sun_over_hall();
    float const slope = (hall_ridge_y - hall_eaves_y) / hall_half_width;
    // Where the way to the sun meets the roof on the right.
    float const t = (hall_ridge_y - slope * position.x - position.y) / (sun.y + slope * sun.x);
    glm::vec3 const roof = position + t * sun;
    return roof.x > 0.f ? skylight(roof, 0.25f) : 0.f;
}

Surface hall_shell_surface(Hit const& hit)
{
    switch (hit.material) {
        case hall_side_wall:
            return side_wall_surface(hit);
        case hall_gate_wall:
            return gate_wall_surface(hit);
        case hall_open_wall:
            return open_wall_surface(hit);
        default:
            return roof_surface(hit);
    }
}
