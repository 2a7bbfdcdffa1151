#include "height_field.h"
#include "noise.h"
#include "raster.h"
#include "textures.h"

#include <algorithm>
#include <cmath>

namespace {
int const size = 512;
int const num_slabs = 2;
int const slab_size = size / num_slabs;

/// To the nearest joint between slabs, in texels. Joints lie inside the texture, not at its border.
float joint_distance(glm::vec2 const& p)
{
    glm::vec2 const slab = float(num_slabs) * p + 0.5f;
    glm::vec2 const distance = glm::abs(slab - glm::floor(slab + 0.5f)) * float(slab_size);
    return std::min(distance.x, distance.y);
}

/// Which slab p is in.
glm::ivec2 slab_at(glm::vec2 const& p)
{
    glm::vec2 const slab = glm::floor(float(num_slabs) * p + 0.5f);
    return glm::ivec2(slab) % num_slabs;
}

/// Air bubbles at one of several sizes, cells a side: 1 in the middle of a bubble, 0 outside.
float pore(glm::vec2 const& p, int cells, float share, std::uint32_t seed)
{
    glm::vec2 const position = float(cells) * p;
    glm::vec2 const cell = glm::floor(position);
    int const i = int(cell.x);
    int const j = int(cell.y);
    if (hash_to_unit(i, j, seed) > share)
        return 0.f;
    glm::vec2 const center =
        0.5f + 0.3f * glm::vec2(hash_to_unit(i, j, seed + 1), hash_to_unit(i, j, seed + 2)) - 0.15f;
    float const radius = 0.12f + 0.2f * hash_to_unit(i, j, seed + 3);
    return 1.f - smooth_step(0.4f * radius, radius, glm::length(position - cell - center));
}

float pores(glm::vec2 const& p)
{
    return std::max(pore(p, 64, 0.09f, 11), pore(p, 24, 0.05f, 12));
}

float floor_height(glm::vec2 const& p)
{
    float const groove = 1.f - smooth_step(1.f, 3.5f, joint_distance(p));
    float const waves = 5.f * periodic_turbulence(8.f * p, 8, 3, 31);
    float const grain = 1.1f * periodic_turbulence(96.f * p, 96, 2, 32);
    return waves + grain - 3.f * groove - 2.2f * pores(p);
}

HeightField make_heights()
{
    return HeightField(size, size, Border::repeat,
                       [](int x, int y) { return floor_height(texel_center(x, y, size, size)); });
}

glm::vec3 floor_color(glm::vec2 const& p)
{
    glm::ivec2 const slab = slab_at(p);
    float const tone = 0.06f * (hash_to_unit(slab.x, slab.y, 41) - 0.5f);
    float const cloud = periodic_turbulence(4.f * p, 4, 5, 42) - 0.5f;
    float const grain = periodic_turbulence(128.f * p, 128, 2, 43) - 0.5f;
    float const stain = smooth_step(0.55f, 0.75f, periodic_turbulence(5.f * p, 5, 4, 44));
    glm::vec3 const ground = glm::vec3(0.635f, 0.625f, 0.605f) + tone + 0.30f * cloud + 0.14f * grain;
    return glm::mix(ground, glm::vec3(0.46f, 0.44f, 0.41f), 0.45f * stain);
}

float shade(glm::vec2 const& p)
{
    float const groove = 1.f - smooth_step(1.2f, 3.2f, joint_distance(p));
    float const dirt = 1.f - smooth_step(2.f, 14.f, joint_distance(p));
    return (1.f - 0.5f * groove) * (1.f - 0.10f * dirt) * (1.f - 0.38f * pores(p));
}
}  // namespace

Image make_concrete_diffuse()
{
    HeightField const heights = make_heights();
    HeightField const surroundings = heights.blurred(3);
    return make_image(size, size, [&](int x, int y) {
        glm::vec2 const p = texel_center(x, y, size, size);
        float const above = std::min(heights.at(x, y) - surroundings.at(x, y), 1.f);
        return floor_color(p) * shade(p) * (1.f + 0.08f * above);
    });
}

Image make_concrete_normal()
{
    return make_normal_map(make_heights(), Bitangent::along_v);
}
