#include "apartment.h"
#include "noise.h"
#include "pattern.h"

#include <algorithm>
#include <cmath>

namespace {
glm::vec3 const oak(0.50f, 0.33f, 0.18f);
glm::vec3 const wall_paint(0.72f, 0.69f, 0.62f);

float on_block(Hit const& hit, int property)
{
    return hash_to_unit(hit.face / 8, property, 91);
}

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
    return oak * (1.f + 0.34f * tone + 0.45f * grain) * (1.f - 0.6f * gap);
}

/// Blue with stripes and a light border.
glm::vec3 rug(glm::vec2 const& p, float footprint)
{
    glm::vec3 const blue(0.10f, 0.17f, 0.27f);
    glm::vec3 const cream(0.66f, 0.60f, 0.48f);
    float const field = in_rectangle({-0.75f, -1.1f}, {1.45f, 1.1f}, p, footprint);
    float const zigzag = std::abs(p.x * 4.f - std::floor(p.x * 4.f) - 0.5f) * 0.10f;
    float const stripe = lines(p.y + zigzag, 0.36f, 0.06f, footprint);
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

/// Houses across the street, of different heights; 0 beside them.
float skyline(float azimuth)
{
    int const house = int(std::floor(azimuth * 14.f));
    return 0.02f + 0.13f * hash_to_unit(house, 0, 61);
}

glm::vec3 facade(float azimuth, float elevation)
{
    int const house = int(std::floor(azimuth * 14.f));
    glm::vec3 const tone(0.62f + 0.3f * hash_to_unit(house, 1, 61), 0.52f + 0.25f * hash_to_unit(house, 2, 61), 0.46f);
    glm::vec2 const p(azimuth * 14.f * 5.f, elevation * 42.f);
    glm::vec2 const cell = p - glm::floor(p);
    float const window = in_rectangle({0.3f, 0.25f}, {0.72f, 0.8f}, cell, 0.08f);
    return tone * (1.f - 0.65f * window);
}

glm::vec3 sky(glm::vec3 const& d)
{
    glm::vec3 const clear =
        glm::mix(glm::vec3(1.25f, 1.5f, 1.75f), glm::vec3(0.45f, 0.85f, 1.7f), smooth_step(0.f, 0.6f, d.y));
    glm::vec2 const p = glm::vec2(d.x, d.z) / (std::max(d.y, 0.f) + 0.25f);
    return glm::mix(clear, glm::vec3(2.4f), smooth_step(0.02f, 0.25f, mottle(p, 0.9f, 62)));
}

/// Sky, houses, and trees in front of them.
glm::vec3 outside(glm::vec3 const& d)
{
    float const azimuth = std::atan2(d.x, -d.z);
    float const trees = -0.10f + 0.13f * periodic_turbulence({azimuth * 9.f + 40.f, 1.f}, 4096, 4, 63);
    glm::vec2 const leaf(azimuth * 70.f + 200.f, d.y * 70.f + 200.f);
    glm::vec3 const green = glm::vec3(0.22f, 0.34f, 0.10f) * (0.4f + 1.2f * periodic_turbulence(leaf, 4096, 3, 64));
    float const roof = skyline(azimuth);
    glm::vec3 const behind = glm::mix(facade(azimuth, d.y), sky(d), smooth_step(roof - 0.002f, roof + 0.002f, d.y));
    return glm::mix(green, behind, smooth_step(trees - 0.006f, trees + 0.006f, d.y));
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

glm::vec3 wood_color(Hit const& hit)
{
    glm::vec3 const p = hit.position;
    bool const is_upright = std::abs(hit.normal.y) < 0.5f;
    glm::vec2 const q = is_upright ? glm::vec2(p.x + p.z, 14.f * p.y) : glm::vec2(p.x + 3.f * p.z, 14.f * p.z);
    float const gap = is_upright && p.x < -2.7f ? lines(p.z + 0.05f, 0.475f, 0.008f, hit.footprint) : 0.f;
    return oak * (1.f + 0.5f * mottle(q, 0.5f, 72)) * (1.f - 0.7f * gap);
}

glm::vec3 book_color(Hit const& hit)
{
    static glm::vec3 const kinds[] = {{0.45f, 0.10f, 0.08f}, {0.10f, 0.20f, 0.38f}, {0.62f, 0.56f, 0.44f},
                                      {0.12f, 0.28f, 0.20f}, {0.55f, 0.36f, 0.08f}, {0.16f, 0.14f, 0.15f},
                                      {0.66f, 0.64f, 0.60f}, {0.36f, 0.16f, 0.30f}};
    glm::vec3 const color = kinds[int(8.f * on_block(hit, 0))] * (0.8f + 0.4f * on_block(hit, 1));
    float const label = lines(hit.position.y - 0.4f * on_block(hit, 2), 0.4f, 0.045f, hit.footprint);
    return glm::mix(color, glm::vec3(0.7f, 0.62f, 0.42f), 0.7f * label);
}

glm::vec3 fabric(Hit const& hit, glm::vec3 const& color)
{
    glm::vec2 const p(hit.position.z + hit.position.x, hit.position.y + hit.position.x);
    return color * (1.f + 0.35f * mottle(p, 0.02f, 73) * visible(0.02f, hit.footprint) + 0.15f * mottle(p, 0.3f, 74));
}

glm::vec3 pillow_color(Hit const& hit)
{
    glm::vec3 const color = hit.position.z > 0.f ? glm::vec3(0.62f, 0.34f, 0.06f) : glm::vec3(0.10f, 0.30f, 0.32f);
    return fabric(hit,
                  glm::mix(color, glm::vec3(0.7f, 0.66f, 0.58f), lines(hit.position.z, 0.1f, 0.02f, hit.footprint)));
}

/// Hills under a low sun, and three bands of colour on the small one.
glm::vec3 painting_color(Hit const& hit)
{
    glm::vec2 const p(hit.position.z, hit.position.y);
    if (p.x > 0.3f) {
        glm::vec3 const low = glm::mix(glm::vec3(0.55f, 0.13f, 0.08f), glm::vec3(0.75f, 0.48f, 0.10f),
                                       between(0.28f, 0.46f, p.y, 0.004f));
        return glm::mix(low, glm::vec3(0.10f, 0.24f, 0.34f), between(0.46f, 1.f, p.y, 0.004f));
    }
    glm::vec3 color = glm::mix(glm::vec3(0.85f, 0.62f, 0.35f), glm::vec3(0.30f, 0.45f, 0.60f), (p.y - 0.1f) / 0.65f);
    color = glm::mix(color, glm::vec3(0.95f, 0.85f, 0.55f),
                     between(-1.f, 0.11f, glm::length(p - glm::vec2(-0.6f, 0.42f)), 0.004f));
    for (int i = 0; i < 3; ++i) {
        float const crest = 0.36f - 0.11f * float(i) + 0.22f * mottle({p.x + 7.f * float(i), 0.f}, 0.45f, 75);
        glm::vec3 const hill =
            glm::mix(glm::vec3(0.28f, 0.36f, 0.42f), glm::vec3(0.08f, 0.16f, 0.12f), 0.5f * float(i));
        color = glm::mix(color, hill, between(-1.f, crest, p.y, 0.004f));
    }
    return color;
}

glm::vec3 curtain_color(Hit const& hit)
{
    float const folds = ribs(hit.position.x + 0.01f * std::sin(5.f * hit.position.y), 0.085f, 0.22f, hit.footprint);
    return glm::vec3(0.60f, 0.50f, 0.38f) * folds;
}

Surface shade_surface(Hit const& hit)
{
    float const paper = ribs(hit.position.y, 0.06f, 0.12f, hit.footprint);
    glm::vec3 const glow = glm::vec3(1.6f, 1.1f, 0.6f) * (0.7f + 0.6f * std::abs(hit.normal.y)) * paper;
    return {glm::vec3(0.6f, 0.55f, 0.45f), glow};
}
}  // namespace

glm::vec3 sun_over_flat()
{
    return glm::normalize(glm::vec3(-0.34f, 0.60f, -0.76f));
}

float sun_in_flat(glm::vec3 const& position)
{
    glm::vec3 const sun = sun_over_flat();
    glm::vec3 const pane = position + sun * ((flat_glass_z - position.z) / sun.z);
    float enters = 0.f;
    for (float const x : flat_windows_x)
        enters += in_rectangle({x - flat_window_half_width, flat_sill_y}, {x + flat_window_half_width, flat_lintel_y},
                               {pane.x, pane.y}, 0.02f);
    return enters;
}

Surface flat_surface(Hit const& hit)
{
    switch (hit.material) {
        case flat_floor:
            return floor_surface(hit);
        case flat_glass:
            return {glm::vec3(0.f), outside(hit.position / hit.t)};
        case flat_wall:
            return {wall_color(hit)};
        case flat_ceiling:
            return {ceiling_color(hit)};
        case flat_curtain:
            return {curtain_color(hit)};
        case flat_radiator:
            return {glm::vec3(0.82f) * ribs(hit.position.x, 0.06f, 0.2f, hit.footprint)};
        case flat_door:
            return {door_color(hit)};
        case flat_metal:
            return {glm::vec3(0.20f, 0.19f, 0.18f)};
        case flat_oak:
            return {wood_color(hit)};
        case flat_book:
            return {book_color(hit)};
        case flat_sofa:
            return {fabric(hit, {0.30f, 0.34f, 0.38f})};
        case flat_pillow:
            return {pillow_color(hit)};
        case flat_frame:
            return {glm::vec3(0.14f, 0.09f, 0.06f)};
        case flat_painting:
            return {painting_color(hit)};
        case flat_shade:
            return shade_surface(hit);
        case flat_plant:
            return {glm::vec3(0.10f, 0.26f, 0.07f) * (0.6f + 0.8f * on_block(hit, 3))};
        case flat_pot:
            return {glm::vec3(0.55f, 0.28f, 0.18f)};
        case flat_screen:
            return {glm::vec3(0.015f)};
        default:
            return {glm::vec3(0.84f, 0.83f, 0.81f)};
    }
}
