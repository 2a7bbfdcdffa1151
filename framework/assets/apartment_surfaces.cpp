#include "apartment.h"
#include "noise.h"
#include "pattern.h"

#include <algorithm>
#include <cmath>

namespace {
glm::vec3 const wall_paint(0.72f, 0.69f, 0.62f);

/// Boards along x of different lengths.
glm::vec3 boards(glm::vec2 const& p, float footprint)
{
    float const width = 0.14f;
    float const row = std::floor(p.y / width);
    float const x = p.x + 1.3f * hash_to_unit(int(row), 0, 51);
    float const board = std::floor(x / 1.5f);
    float const gap = std::max(lines(p.y, width, 0.004f, footprint), lines(x, 1.5f, 0.004f, footprint));
    float const tone = hash_to_unit(int(board), int(row), 52) - 0.5f;
    float const shift = 30.f * hash_to_unit(int(board), int(row), 53);
    float const grain = mottle({1.2f * p.x + shift, 26.f * p.y}, 1.f, 54) * visible(0.05f, footprint);
    return flat_oak_color * (1.f + 0.34f * tone + 0.45f * grain) * (1.f - 0.6f * gap);
}

/// Blue with stripes and a light border.
glm::vec3 rug(glm::vec2 const& p, float footprint)
{
    glm::vec3 const blue(0.10f, 0.17f, 0.27f);
    glm::vec3 const cream(0.66f, 0.60f, 0.48f);
    float const field = in_rectangle({-0.75f, -1.1f}, {1.45f, 1.1f}, p, footprint);
    float const zigzag = std::abs(p.x * 4.f - std::floor(p.x * 4.f) - 0.5f) * 0.10f;
    float const stripe = lines(p.y + zigzag, 0.27f, 0.035f, footprint);
    glm::vec3 const inner =
        glm::mix(blue, glm::mix(cream, glm::vec3(0.5f, 0.16f, 0.10f), between(-0.55f, 0.55f, p.y, footprint)), stripe);
    return glm::mix(cream, inner, field) * (1.f + 0.3f * mottle(p, 0.03f, 55) * visible(0.03f, footprint));
}

Surface floor_surface(Hit const& hit)
{
    glm::vec2 const p(hit.position.x, hit.position.z);
    float const f = hit.footprint;
    float const on_rug = in_rectangle({-0.85f, -1.2f}, {1.55f, 1.2f}, p, f);
    return {on_rug > 0.f ? glm::mix(boards(p, f), rug(p, f), on_rug) : boards(p, f)};
}

glm::vec3 wall_color(Hit const& hit)
{
    glm::vec3 const p = hit.position;
    float const along = std::abs(hit.normal.x) > 0.5f ? p.z : p.x;
    float const skirting = between(-1.f, 0.10f, p.y - flat_floor_y, hit.footprint);
    glm::vec3 const paint = p.x < -3.19f ? glm::vec3(0.36f, 0.46f, 0.44f) : wall_paint;
    return glm::mix(paint * (1.f + 0.06f * mottle({along, p.y}, 0.5f, 71)), glm::vec3(0.82f), skirting);
}

glm::vec3 ceiling_color(Hit const& hit)
{
    glm::vec2 const inset(flat_half_width - std::abs(hit.position.x), flat_half_depth - std::abs(hit.position.z));
    float const nearest = std::min(inset.x, inset.y);
    float const edge = std::max(lines(nearest - 0.10f, 100.f, 0.012f, hit.footprint),
                                lines(nearest - 0.14f, 100.f, 0.012f, hit.footprint));
    return glm::vec3(0.84f, 0.83f, 0.80f) * (1.f - 0.35f * edge);
}

/// Two panels, bordered by a light and a dark line.
glm::vec3 door_color(Hit const& hit)
{
    glm::vec2 const p(hit.position.z, hit.position.y - flat_floor_y);
    float const f = hit.footprint;
    float panel = 0.f;
    float inner = 0.f;
    for (glm::vec2 const& y : {glm::vec2(0.2f, 0.9f), glm::vec2(1.15f, 1.9f)}) {
        panel += in_rectangle({0.62f, y.x}, {1.2f, y.y}, p, f);
        inner += in_rectangle({0.645f, y.x + 0.025f}, {1.175f, y.y - 0.025f}, p, f);
    }
    return glm::vec3(0.78f, 0.77f, 0.73f) * (1.f - 0.35f * (panel - inner));
}
}  // namespace

Surface flat_surface(Hit const& hit)
{
    switch (hit.material) {
        case flat_floor:
            return floor_surface(hit);
        case flat_glass:
            return {glm::vec3(0.f), outside_flat(hit.position / hit.t)};
        case flat_wall:
            return {wall_color(hit)};
        case flat_ceiling:
            return {ceiling_color(hit)};
        case flat_door:
            return {door_color(hit)};
        default:
            return furniture_surface(hit);
    }
}
