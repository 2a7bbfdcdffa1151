#include "bench/patterns.h"

#include "checks/textures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace testat::bench {
namespace {
glm::dvec3 checker(int x, int y, int side)
{
    constexpr int fields = 8;
    int const field = side / fields;
    return glm::dvec3((x / field + y / field) % 2);
}

/// Waves that meet at the borders.
glm::dvec3 smooth(int x, int y, int side)
{
    constexpr double turn = 6.283185307179586;
    double const u = turn * (x + 0.5) / side;
    double const v = turn * (y + 0.5) / side;
    return {0.5 + 0.3 * std::sin(u) * std::cos(2 * v) + 0.2 * std::sin(u + v), 0.5 + 0.5 * std::sin(2 * u - v),
            0.5 + 0.25 * std::cos(3 * u) + 0.25 * std::sin(3 * v)};
}

/// Of a counter; murmur3's finaliser.
std::uint32_t scrambled(std::uint32_t h)
{
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    return h ^ (h >> 16);
}

glm::dvec3 noise(int x, int y, int side)
{
    std::uint32_t const first = 3u * static_cast<std::uint32_t>(y * side + x) + 1;
    return {scrambled(first) * 0x1p-32, scrambled(first + 1) * 0x1p-32, scrambled(first + 2) * 0x1p-32};
}

using Texels = std::vector<glm::dvec4>;

Texels level_zero(Pattern const& pattern, int side)
{
    Texels texels;
    texels.reserve(std::size_t(side) * std::size_t(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            texels.emplace_back(pattern.colour(x, y, side), 1);
    return texels;
}

Texels halved(Texels const& finer, int side)
{
    Texels texels;
    auto const at = [&](int x, int y) { return finer[std::size_t(y) * std::size_t(side) + std::size_t(x)]; };
    for (int y = 0; y < side; y += 2)
        for (int x = 0; x < side; x += 2)
            texels.push_back((at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) / 4.0);
    return texels;
}

TextureData::Level rounded(Texels const& texels, int side)
{
    TextureData::Level level{side, side, {}};
    level.texels.reserve(4 * texels.size());
    for (auto const& texel : texels)
        for (int i = 0; i < 4; ++i)
            level.texels.push_back(static_cast<float>(texel[i]));
    return level;
}
}  // namespace

std::vector<Pattern> const& patterns()
{
    static std::vector<Pattern> const all = {
        {"checker", {"Schachbrett", "checker"}, checker},
        {"smooth", {"weich", "smooth"}, smooth},
        {"noise", {"Rauschen", "noise"}, noise},
    };
    return all;
}

TextureData make_texture(Pattern const& pattern, int side)
{
    TextureData texture{static_cast<std::uint32_t>(Wrap::repeat), {}};
    Texels texels = level_zero(pattern, side);
    texture.levels.push_back(rounded(texels, side));
    for (; side > 1; side /= 2) {
        texels = halved(texels, side);
        texture.levels.push_back(rounded(texels, side / 2));
    }
    return texture;
}
}  // namespace testat::bench
