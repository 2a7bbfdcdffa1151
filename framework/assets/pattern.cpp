#include "pattern.h"

#include "noise.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

float visible(float period, float footprint)
{
    return 1.f - smooth_step(0.2f, 0.6f, footprint / period);
}

float ribs(float position, float period, float strength, float footprint)
{
    return 1.f + strength * visible(period, footprint) * std::sin(glm::two_pi<float>() * position / period);
}

float lines(float position, float period, float line_width, float footprint)
{
    float const distance = std::abs(position - period * std::floor(position / period + 0.5f));
    float const width = std::max(line_width, footprint);
    float const seen = 1.f - smooth_step(0.5f * width - 0.5f * footprint, 0.5f * width + 0.5f * footprint, distance);
    return seen * line_width / width;
}

float between(float low, float high, float position, float footprint)
{
    float const inside = std::min(position - low, high - position);
    return glm::clamp(0.5f + inside / std::max(footprint, 1e-4f), 0.f, 1.f);
}

float in_rectangle(glm::vec2 const& low, glm::vec2 const& high, glm::vec2 const& position, float footprint)
{
    return between(low.x, high.x, position.x, footprint) * between(low.y, high.y, position.y, footprint);
}

float mottle(glm::vec2 const& position, float size, std::uint32_t seed)
{
    return periodic_turbulence(position / size, 4096, 3, seed) - 0.5f;
}
