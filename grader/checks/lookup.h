#pragma once
#include "checks/check.h"

#include <array>

/// Oracles in double for texture lookups, with what a correct float implementation may be off by.
namespace testat {
struct Lookup {
    glm::dvec4 value;
    glm::dvec4 bound;
};

/// How far s = u * size may be off in float: product, conversion and the subtraction of one half (GRADING.md 3).
double coordinate_error(double u, int size);

/// Bilinear value at uv on a level. |error| <= Gs (ds + eps) + Gt (dt + eps) + 8 eps Cmax, with G the largest step
/// between neighbouring texels as far away as the error of a coordinate reaches: within the 4 x 4 neighbourhood, and
/// one texel farther for |u| W near 2^23, where that error is above one texel.
Lookup bilinear(TextureData const& texture, int level, glm::dvec2 uv);

/// Trilinear value. T = log2(max(du W, dv H)) is uncertain by its roundings; the value is continuous and piecewise
/// linear in T, so the error of T counts with the largest step between levels, unless T is beyond the last for sure.
Lookup trilinear(TextureData const& texture, glm::dvec2 uv, glm::dvec2 dudv);

/// A uv that lies at texel coordinate st of a level, up to float rounding.
void store_uv(glm::dvec2 st, glm::ivec2 size, float* uv);

Deviation compare_lookup(Answers const& answers, std::uint32_t index, Lookup const& right, Words words);

/// One lookup in two textures, and the one that must give their mean: f(T3) = (f(T1) + f(T2)) / 2, in this order.
struct MeanOfTextures {
    std::array<LookupQuestion, 3> questions;
    double bound;  ///< in each channel
};

Deviation compare_mean(Answers const& answers, MeanOfTextures const& relation,
                       std::array<std::uint32_t, 3> const& places);

/// A coordinate in texel `i`, at a fraction in [lo, hi).
double inside_texel(Random& random, int i, double lo, double hi);
}  // namespace testat
