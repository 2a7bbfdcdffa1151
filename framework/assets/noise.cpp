#include "noise.h"

#include <algorithm>
#include <cmath>

namespace {
/// An invertible mix of all bits (the finalizer of MurmurHash3).
std::uint32_t mix_bits(std::uint32_t h)
{
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    return h ^ (h >> 16);
}

int wrap(int value, int period)
{
    // Most are inside, and division is slow.
    if (value >= 0 && value < period)
        return value;
    int const remainder = value % period;
    return remainder < 0 ? remainder + period : remainder;
}
}  // namespace

float hash_to_unit(int x, int y, std::uint32_t seed)
{
    std::uint32_t const h = mix_bits(mix_bits(mix_bits(seed) + std::uint32_t(x)) + std::uint32_t(y));
    return float(h >> 8) * (1.f / 16777216.f);
}

float smooth_step(float low, float high, float value)
{
    float const x = std::min(std::max((value - low) / (high - low), 0.f), 1.f);
    return x * x * (3.f - 2.f * x);
}

float periodic_noise(glm::vec2 const& p, int period, std::uint32_t seed)
{
    glm::vec2 const cell(std::floor(p.x), std::floor(p.y));
    int const x[] = {wrap(int(cell.x), period), wrap(int(cell.x) + 1, period)};
    int const y[] = {wrap(int(cell.y), period), wrap(int(cell.y) + 1, period)};
    auto const at = [&](int i, int j) { return hash_to_unit(x[i], y[j], seed); };
    glm::vec2 const f(smooth_step(0.f, 1.f, p.x - cell.x), smooth_step(0.f, 1.f, p.y - cell.y));
    float const lower = at(0, 0) + f.x * (at(1, 0) - at(0, 0));
    float const upper = at(0, 1) + f.x * (at(1, 1) - at(0, 1));
    return lower + f.y * (upper - lower);
}

float periodic_turbulence(glm::vec2 const& p, int period, int num_octaves, std::uint32_t seed)
{
    float sum = 0.f;
    float weights = 0.f;
    for (int octave = 0; octave < num_octaves; ++octave) {
        float const frequency = float(1 << octave);
        sum += periodic_noise(frequency * p, period << octave, seed + std::uint32_t(octave)) / frequency;
        weights += 1.f / frequency;
    }
    return sum / weights;
}
