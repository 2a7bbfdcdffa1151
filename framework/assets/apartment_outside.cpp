#include "apartment.h"
#include "noise.h"
#include "pattern.h"

#include <algorithm>
#include <cmath>

namespace {
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
}  // namespace

glm::vec3 outside_flat(glm::vec3 const& d)
{
    float const azimuth = std::atan2(d.x, -d.z);
    float const trees = -0.10f + 0.13f * periodic_turbulence({azimuth * 9.f + 40.f, 1.f}, 4096, 4, 63);
    glm::vec2 const leaf(azimuth * 70.f + 200.f, d.y * 70.f + 200.f);
    glm::vec3 const green = glm::vec3(0.22f, 0.34f, 0.10f) * (0.4f + 1.2f * periodic_turbulence(leaf, 4096, 3, 64));
    float const roof = skyline(azimuth);
    glm::vec3 const behind = glm::mix(facade(azimuth, d.y), sky(d), smooth_step(roof - 0.002f, roof + 0.002f, d.y));
    return glm::mix(green, behind, smooth_step(trees - 0.006f, trees + 0.006f, d.y));
}

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
