#pragma once
#include "bench/scenes.h"
#include "protocol/request.h"

#include <filesystem>

/// What a pixel should show: the mean of the texture over the pixel's area. The texture is that of level 0,
/// interpolated bilinearly, because that is what a camera shows that is near enough; the area is the square of the
/// pixel, with all its points alike, carried to the surface ray by ray.
namespace testat::bench {
/// Rays through each pixel, at least; stratified and jittered. Footprints longer than this many half texels get one for
/// each half texel along that side, up to `most_strata` squared.
constexpr int least_strata = 48;  // squared: 2304
constexpr int most_strata = 96;

/// One for each of `textures`. `strata`: rays along each side of a pixel, at least.
std::vector<Truth> find_truth(Scene const& scene, View const& view, std::vector<TextureData> const& textures,
                              int strata = least_strata);

/// The colour of level 0 at uv, bilinearly, in double. The texture is repeated, its sides are powers of two.
glm::dvec3 signal(TextureData::Level const& level, glm::dvec2 uv);
}  // namespace testat::bench
