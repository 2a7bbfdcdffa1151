#include "noise.h"
#include "raster.h"
#include "textures.h"

#include <cmath>

namespace {
int const size = 128;
int const fields = 8;
int const field_size = size / fields;

/// How marble looks: its ground, the clouds in it, its veins.
struct Marble {
    glm::vec3 ground;
    glm::vec3 cloud;
    glm::vec3 vein;
    /// Whole numbers, so that the veins meet at the borders: how many bands they cross along x and along y.
    glm::vec2 bands;
    std::uint32_t seed;
};

Marble const light = {{0.93f, 0.86f, 0.73f}, {0.83f, 0.70f, 0.52f}, {0.54f, 0.37f, 0.24f}, {3.f, 2.f}, 11};
Marble const dark = {{0.13f, 0.25f, 0.29f}, {0.19f, 0.36f, 0.38f}, {0.66f, 0.75f, 0.68f}, {-2.f, 3.f}, 47};

/// 1 where a band begins, 0 half a band away.
float ridge(float position)
{
    return std::abs(2.f * (position - std::floor(position)) - 1.f);
}

/// p in [0, 1)^2 covers the texture.
float vein(Marble const& marble, glm::vec2 const& p)
{
    float const bend = 3.2f * periodic_turbulence(4.f * p, 4, 4, marble.seed);
    float const strength = periodic_noise(5.f * p, 5, marble.seed + 17);
    return smooth_step(0.80f, 1.f, ridge(marble.bands.x * p.x + marble.bands.y * p.y + bend)) *
           (0.35f + 0.65f * strength);
}

glm::vec3 marble_color(Marble const& marble, glm::vec2 const& p)
{
    float const cloud = smooth_step(0.35f, 0.75f, periodic_turbulence(3.f * p, 3, 4, marble.seed + 31));
    return glm::mix(glm::mix(marble.ground, marble.cloud, cloud), marble.vein, vein(marble, p));
}

/// Each field is a stone of its own, a little lighter or darker, and grainy.
float tone(int x, int y)
{
    float const stone = hash_to_unit(x / field_size, y / field_size, 5) - 0.5f;
    float const grain = hash_to_unit(x, y, 6) - 0.5f;
    return 1.f + 0.16f * stone + 0.05f * grain;
}

glm::vec3 texel(int x, int y)
{
    glm::vec2 const p = texel_center(x, y, size, size);
    bool const is_light = (x / field_size + y / field_size) % 2 == 0;
    return tone(x, y) * marble_color(is_light ? light : dark, p);
}
}  // namespace

Image make_checker()
{
    return make_image(size, size, texel);
}
