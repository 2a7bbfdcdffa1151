#include "apartment.h"
#include "noise.h"
#include "pattern.h"

#include <algorithm>
#include <cmath>

namespace {
float on_block(Hit const& hit, int property)
{
    return hash_to_unit(hit.face / 8, property, 91);
}

glm::vec3 wood_color(Hit const& hit)
{
    glm::vec3 const p = hit.position;
    bool const is_upright = std::abs(hit.normal.y) < 0.5f;
    glm::vec2 const q = is_upright ? glm::vec2(p.x + p.z, 14.f * p.y) : glm::vec2(p.x + 3.f * p.z, 14.f * p.z);
    float const gap = is_upright && p.x < -2.7f ? lines(p.z + 0.05f, 0.475f, 0.008f, hit.footprint) : 0.f;
    return flat_oak_color * (1.f + 0.5f * mottle(q, 0.5f, 72)) * (1.f - 0.7f * gap);
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

Surface furniture_surface(Hit const& hit)
{
    switch (hit.material) {
        case flat_curtain:
            return {curtain_color(hit)};
        case flat_radiator:
            return {glm::vec3(0.82f) * ribs(hit.position.x, 0.06f, 0.2f, hit.footprint)};
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
