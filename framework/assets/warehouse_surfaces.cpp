#include "noise.h"
#include "pattern.h"
#include "warehouse.h"

#include <algorithm>
#include <cmath>

namespace {
/// What the skylights add to a smooth floor: brighter where it is seen flat.
glm::vec3 gloss(Hit const& hit)
{
    glm::vec3 const d = hit.position / hit.t;
    glm::vec3 const mirrored(d.x, -d.y, d.z);
    float const height = 8.2f - hall_floor_y;
    glm::vec3 const roof = hit.position + mirrored * (height / std::max(mirrored.y, 0.02f));
    float const grazing = std::pow(1.f - mirrored.y, 4.f);
    return hall_sky * (0.03f + 0.35f * grazing) * skylight(roof, 0.9f);
}

Surface floor_surface(Hit const& hit)
{
    glm::vec2 const p(hit.position.x, hit.position.z);
    float const f = hit.footprint;
    float const joint = std::max(lines(p.x - 2.f, 4.f, 0.03f, f), lines(p.y, 4.f, 0.03f, f));
    float const cloud = mottle(p, 1.6f, 6);
    float const stain = smooth_step(0.08f, 0.3f, mottle(p, 4.f, 5));
    float const grain = visible(0.15f, f) * (periodic_noise(p / 0.08f, 4096, 7) - 0.5f);
    glm::vec3 color = glm::vec3(0.30f, 0.295f, 0.285f) * (1.f + 0.5f * cloud + 0.14f * grain);
    color *= (1.f - 0.5f * joint) * (1.f - 0.4f * stain);
    float const marking = lines(std::abs(p.x) - 7.5f, 100.f, 0.14f, f) * glm::clamp(0.85f + cloud, 0.f, 1.f);
    return {glm::mix(color, glm::vec3(0.72f, 0.52f, 0.08f), marking), gloss(hit) * (0.9f - 0.9f * cloud)};
}

glm::vec3 column_color(Hit const& hit)
{
    float const above = hit.position.y - hall_floor_y;
    float const across = hit.position.z + hit.position.x;
    return glm::mix(hall_grey, hazard(across + above, hit.footprint), between(0.f, 1.4f, above, hit.footprint));
}

glm::vec3 crate_color(Hit const& hit)
{
    static glm::vec3 const kinds[] = {{0.48f, 0.33f, 0.19f}, {0.56f, 0.42f, 0.26f}, {0.42f, 0.28f, 0.16f},
                                      {0.62f, 0.60f, 0.56f}, {0.15f, 0.28f, 0.46f}, {0.50f, 0.36f, 0.21f}};
    int const block = hit.face / 8;
    glm::vec3 const color = kinds[int(6.f * hash_to_unit(block, 0, 31))] * (0.8f + 0.4f * hash_to_unit(block, 1, 31));
    float const strip = lines(hit.position.y - hash_to_unit(block, 2, 31), 0.7f, 0.06f, hit.footprint);
    return glm::mix(color, color * 0.65f, strip);
}

glm::vec3 plank_color(Hit const& hit)
{
    float const position = hit.position.y - hall_floor_y;
    float const gap = lines(position, 0.2f, 0.025f, hit.footprint);
    float const tone = hash_to_unit(int(position / 0.2f), hit.face, 33);
    float const grain = mottle({4.f * (hit.position.x + hit.position.z), 40.f * position}, 1.f, 34);
    return glm::vec3(0.52f, 0.37f, 0.21f) * (0.8f + 0.3f * tone + 0.25f * grain) * (1.f - 0.7f * gap);
}

glm::vec3 container_color(Hit const& hit, glm::vec3 const& paint)
{
    glm::vec2 const p(hit.position.x + hit.position.z, hit.position.y);
    return paint * ribs(p.x, 0.28f, 0.3f, hit.footprint) * (1.f + 0.4f * mottle(p, 0.9f, 36));
}
}  // namespace

Surface hall_surface(Hit const& hit)
{
    switch (hit.material) {
        case hall_floor:
            return floor_surface(hit);
        case hall_side_wall:
        case hall_gate_wall:
        case hall_open_wall:
        case hall_roof:
            return hall_shell_surface(hit);
        case hall_column:
            return {column_color(hit)};
        case hall_rack:
            return {glm::vec3(0.10f, 0.20f, 0.42f)};
        case hall_board:
            return {glm::vec3(0.80f, 0.32f, 0.06f)};
        case hall_crate:
            return {crate_color(hit)};
        case hall_plank:
            return {plank_color(hit)};
        case hall_container_red:
            return {container_color(hit, {0.50f, 0.12f, 0.08f})};
        case hall_container_blue:
            return {container_color(hit, {0.08f, 0.22f, 0.42f})};
        case hall_lamp:
            return {glm::vec3(0.6f), hit.normal.y < -0.5f ? glm::vec3(3.f) : glm::vec3(0.f)};
        default:
            return {0.6f * hall_grey};
    }
}
