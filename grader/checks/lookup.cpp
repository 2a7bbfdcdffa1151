#include "checks/lookup.h"

#include "checks/vectors.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat {
namespace {
/// Largest componentwise difference between neighbours along x and along y, within `reach` around (x..x+1, y..y+1).
struct Steps {
    glm::dvec4 along_s{0};
    glm::dvec4 along_t{0};
    glm::dvec4 largest{0};
};

Steps steps_around(TextureData const& texture, int level, int x, int y, glm::ivec2 reach)
{
    Steps steps;
    int const end_x = x + 1 + reach.x;
    int const end_y = y + 1 + reach.y;
    for (int j = y - reach.y; j <= end_y; ++j)
        for (int i = x - reach.x; i <= end_x; ++i) {
            glm::dvec4 const here = texel(texture, level, i, j);
            steps.largest = glm::max(steps.largest, glm::abs(here));
            if (i < end_x)
                steps.along_s = glm::max(steps.along_s, glm::abs(texel(texture, level, i + 1, j) - here));
            if (j < end_y)
                steps.along_t = glm::max(steps.along_t, glm::abs(texel(texture, level, i, j + 1) - here));
        }
    return steps;
}

/// log2 of the footprint in texels with the error its float evaluation may have: one rounding of du * W, which log2
/// turns into eps / ln 2, and two of log2 itself.
struct LevelOfDetail {
    double value;
    double error;
};

LevelOfDetail level_of_detail(glm::ivec2 size, glm::dvec2 dudv)
{
    double const footprint = std::max(dudv.x * size.x, dudv.y * size.y);
    if (!(footprint > 1))
        return {0, footprint >= 1 - 4 * eps ? 4 * eps : 0};
    double const t = std::log2(footprint);
    return {t, 4 * eps + 4 * eps * t};
}
}  // namespace

double coordinate_error(double u, int size)
{
    return eps * (3 * std::abs(u) * size + size + 1);
}

Lookup bilinear(TextureData const& texture, int level, glm::dvec2 uv)
{
    glm::ivec2 const size = level_size(texture, level);
    double const s = uv.x * size.x - 0.5;
    double const t = uv.y * size.y - 0.5;
    int const x = static_cast<int>(std::floor(s));
    int const y = static_cast<int>(std::floor(t));
    auto const row = [&](int j) {
        return glm::mix(texel(texture, level, x, j), texel(texture, level, x + 1, j), s - x);
    };
    double const ds = coordinate_error(uv.x, size.x) + eps;
    double const dt = coordinate_error(uv.y, size.y) + eps;
    Steps const steps = steps_around(texture, level, x, y, glm::ceil(glm::dvec2(ds, dt)));
    return {glm::mix(row(y), row(y + 1), t - y), steps.along_s * ds + steps.along_t * dt + 8 * eps * steps.largest};
}

Lookup trilinear(TextureData const& texture, glm::dvec2 uv, glm::dvec2 dudv)
{
    int const last = static_cast<int>(texture.levels.size()) - 1;
    LevelOfDetail const lod = level_of_detail(level_size(texture, 0), dudv);
    double const t = std::min(lod.value, double(last));
    int const finer = std::min(static_cast<int>(t), last);
    int const coarser = std::min(finer + 1, last);
    // The error of T may reach into the level before or behind.
    int const before = std::max(finer - 1, 0);
    int const behind = std::min(coarser + 1, last);

    Lookup const a = bilinear(texture, finer, uv);
    Lookup const b = bilinear(texture, coarser, uv);
    glm::dvec4 const step =
        glm::max(glm::abs(b.value - a.value), glm::max(glm::abs(a.value - bilinear(texture, before, uv).value),
                                                       glm::abs(bilinear(texture, behind, uv).value - b.value)));
    glm::dvec4 const largest = glm::max(glm::abs(a.value), glm::abs(b.value));
    double const error = lod.value - lod.error >= last ? 0 : lod.error;
    return {glm::mix(a.value, b.value, t - finer), glm::max(a.bound, b.bound) + step * error + 4 * eps * largest};
}

void store_uv(glm::dvec2 st, glm::ivec2 size, float* uv)
{
    store(st / glm::dvec2(size), uv);
}

Deviation compare_lookup(Answers const& answers, std::uint32_t index, Lookup const& right, Words words)
{
    auto const measured = floats<4>(answers, index);
    auto const list = [](glm::dvec4 v) { return std::vector<double>{v.x, v.y, v.z, v.w}; };
    return compare({measured.begin(), measured.end()}, list(right.value), list(right.bound), words);
}

Deviation compare_mean(Answers const& answers, MeanOfTextures const& relation,
                       std::array<std::uint32_t, 3> const& places)
{
    std::vector<double> one, two, measured, mean;
    for (std::size_t c = 0; c < 4; ++c) {
        one.push_back(floats<4>(answers, places[0])[c]);
        two.push_back(floats<4>(answers, places[1])[c]);
        measured.push_back(floats<4>(answers, places[2])[c]);
        mean.push_back((one[c] + two[c]) / 2);
    }
    Deviation deviation = compare(measured, mean, std::vector<double>(4, relation.bound));
    deviation.measured =
        fmt::format("f(T1) = {}, f(T2) = {}, f(T3) = {}", format_vector(one), format_vector(two), deviation.measured);
    deviation.expected = "f(T3) = (f(T1) + f(T2)) / 2 = " + deviation.expected;
    return deviation;
}

double inside_texel(Random& random, int i, double lo, double hi)
{
    return i + random.uniform(lo, hi);
}
}  // namespace testat
