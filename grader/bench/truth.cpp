#include "bench/truth.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace testat::bench {
namespace {
/// Random numbers of one pixel, the same on every machine: splitmix64.
class Jitter {
public:
    explicit Jitter(std::uint64_t pixel) : state_(pixel * 0x9e3779b97f4a7c15u) {}
    /// In [0, 1).
    double next()
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

/// Of a footprint along its sides, for the largest of the textures.
glm::ivec2 strata_of(Footprint const& footprint, int texels, int least)
{
    glm::dvec2 const half_texels = 2.0 * texels * glm::dvec2(glm::length(footprint.dx), glm::length(footprint.dy));
    return glm::clamp(glm::ivec2(glm::min(half_texels, double(most_strata))), least, std::max(least, most_strata));
}

/// Where the rays through a pixel meet the surface.
std::vector<glm::dvec2> sample(Scene const& scene, View const& view, std::size_t i, glm::ivec2 strata)
{
    Jitter jitter(i + 1);
    std::vector<glm::dvec2> uvs;
    uvs.reserve(std::size_t(strata.x) * std::size_t(strata.y));
    for (int y = 0; y < strata.y; ++y)
        for (int x = 0; x < strata.x; ++x) {
            double const jitter_x = jitter.next();
            glm::dvec2 const place = (glm::dvec2(x, y) + glm::dvec2(jitter_x, jitter.next())) / glm::dvec2(strata);
            auto const hit = scene.hit(ray_through(scene.eye, glm::dvec2(view.pixels[i]) + place, view.side));
            if (hit)
                uvs.push_back(scene.uv(hit->position));
        }
    return uvs;
}

glm::dvec3 mean_over(std::vector<glm::dvec2> const& uvs, TextureData::Level const& level)
{
    glm::dvec3 sum(0);
    for (auto const& uv : uvs)
        sum += signal(level, uv);
    return sum / double(uvs.size());
}

int largest_side(std::vector<TextureData> const& textures)
{
    int side = 1;
    for (auto const& texture : textures)
        side = std::max({side, texture.levels[0].width, texture.levels[0].height});
    return side;
}
}  // namespace

glm::dvec3 signal(TextureData::Level const& level, glm::dvec2 uv)
{
    double const s = uv.x * level.width - 0.5;
    double const t = uv.y * level.height - 0.5;
    double const s0 = std::floor(s);
    double const t0 = std::floor(t);
    auto const x = static_cast<std::int64_t>(s0);
    auto const y = static_cast<std::int64_t>(t0);
    auto const texel = [&](std::int64_t i, std::int64_t j) {
        std::int64_t const at = (j & (level.height - 1)) * level.width + (i & (level.width - 1));
        float const* c = &level.texels[4 * static_cast<std::size_t>(at)];
        return glm::dvec3(c[0], c[1], c[2]);
    };
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), s - s0),
                    glm::mix(texel(x, y + 1), texel(x + 1, y + 1), s - s0), t - t0);
}

std::vector<Truth> find_truth(Scene const& scene, View const& view, std::vector<TextureData> const& textures,
                              int strata)
{
    std::vector<Truth> truths(textures.size(), Truth(view.pixels.size()));
    int const side = largest_side(textures);
    tbb::parallel_for(std::size_t(0), view.pixels.size(), [&](std::size_t i) {
        auto const uvs = sample(scene, view, i, strata_of(view.footprints[i], side, strata));
        for (std::size_t t = 0; t < textures.size(); ++t)
            truths[t][i] = mean_over(uvs, textures[t].levels[0]);
    });
    return truths;
}
}  // namespace testat::bench
