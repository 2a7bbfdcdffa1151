#include "height_field.h"
#include "masonry.h"
#include "noise.h"
#include "raster.h"
#include "textures.h"

#include <algorithm>

namespace {
int const size = 1024;
float const joint = 0.035f;
float const stone_height = 13.f;
Masonry const masonry(7, 6, 71);

/// Straight borders would look sawn.
StonePoint stone_at(glm::vec2 const& p)
{
    glm::vec2 const coarse(periodic_noise(16.f * p, 16, 3), periodic_noise(16.f * p, 16, 4));
    glm::vec2 const fine(periodic_noise(50.f * p, 50, 5), periodic_noise(50.f * p, 50, 6));
    return masonry.find(p + 0.018f * (coarse - 0.5f) + 0.006f * (fine - 0.5f));
}

float property(StonePoint const& point, std::uint32_t seed)
{
    return hash_to_unit(point.stone.x, point.stone.y, seed);
}

/// 0 in the mortar, 1 on a stone.
float stoniness(StonePoint const& point)
{
    return smooth_step(joint, joint + 0.03f, point.border);
}

/// Each stone is its own dome, leans to one side and is hewn.
float stone_relief(StonePoint const& point, glm::vec2 const& p)
{
    glm::vec2 const lean(property(point, 21) - 0.5f, property(point, 22) - 0.5f);
    float const edge = smooth_step(joint - 0.01f, joint + 0.15f, point.border);
    float const hewn = periodic_turbulence(20.f * p, 20, 5, 23 + std::uint32_t(point.stone.x));
    return stone_height * edge * (0.8f + 0.4f * property(point, 24)) + edge * glm::dot(lean, point.offset) * 14.f +
           22.f * edge * (hewn - 0.5f) + 10.f * std::min(point.border, 0.3f);
}

float wall_height(glm::vec2 const& p)
{
    StonePoint const point = stone_at(p);
    if (stoniness(point) == 1.f)
        return stone_relief(point, p);
    float const mortar = 5.f * (periodic_turbulence(64.f * p, 64, 3, 31) - 0.5f);
    return glm::mix(mortar, stone_relief(point, p), stoniness(point));
}

HeightField make_heights()
{
    return HeightField(size, size, Border::repeat,
                       [](int x, int y) { return wall_height(texel_center(x, y, size, size)); });
}

/// Granite, sandstone, slate: each stone is between two of them.
glm::vec3 stone_tone(StonePoint const& point)
{
    static glm::vec3 const kinds[] = {{0.60f, 0.57f, 0.53f}, {0.68f, 0.58f, 0.45f}, {0.47f, 0.49f, 0.51f},
                                      {0.56f, 0.47f, 0.39f}, {0.66f, 0.63f, 0.57f}, {0.50f, 0.44f, 0.40f}};
    int const kind = int(property(point, 41) * 6.f);
    glm::vec3 const tone = glm::mix(kinds[kind], kinds[(kind + 1) % 6], 0.5f * property(point, 42));
    return tone * (0.88f + 0.32f * property(point, 43));
}

glm::vec3 stone_color(StonePoint const& point, glm::vec2 const& p)
{
    float const stain = periodic_turbulence(9.f * p, 9, 4, 51 + std::uint32_t(point.stone.y));
    float const speckle = periodic_noise(256.f * p, 256, 52);
    float const lichen = smooth_step(0.62f, 0.75f, periodic_turbulence(12.f * p, 12, 5, 53));
    glm::vec3 const stone = stone_tone(point) * (0.64f + 0.56f * stain + 0.16f * (speckle - 0.5f));
    return glm::mix(stone, glm::vec3(0.60f, 0.60f, 0.44f), 0.45f * lichen);
}

glm::vec3 mortar_color(glm::vec2 const& p)
{
    return glm::vec3(0.66f, 0.64f, 0.60f) * (0.75f + 0.4f * periodic_turbulence(90.f * p, 90, 3, 61));
}

/// What lies deeper than its surroundings, or its neighbours, gets less light.
glm::vec3 wall_color(glm::vec2 const& p, float above_surroundings, float above_neighbours)
{
    StonePoint const point = stone_at(p);
    float const stony = stoniness(point);
    glm::vec3 const color =
        stony < 1.f ? glm::mix(mortar_color(p), stone_color(point, p), stony) : stone_color(point, p);
    return color * glm::clamp(0.98f + 0.055f * above_surroundings + 0.10f * above_neighbours, 0.25f, 1.25f);
}
}  // namespace

Image make_stonewall_diffuse()
{
    HeightField const heights = make_heights();
    HeightField const surroundings = heights.blurred(10);
    HeightField const neighbours = heights.blurred(2);
    return make_image(size, size, [&](int x, int y) {
        float const h = heights.at(x, y);
        return wall_color(texel_center(x, y, size, size), h - surroundings.at(x, y), h - neighbours.at(x, y));
    });
}

Image make_stonewall_normal()
{
    return make_normal_map(make_heights(), Bitangent::against_v);
}
