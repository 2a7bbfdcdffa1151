#pragma once
#include "bench/footprint.h"
#include "bench/title.h"
#include "protocol/request.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// The ways to filter a texture that `testat bench` compares: the sheet's as the reference solution has them, the same
/// written for speed, and what lies beyond the sheet.
namespace testat::bench {
/// Looks up `count` footprints and writes as many colours. Textures are repeated and square, sides are powers of two up
/// to 8192. uv and its changes are finite, and |u| times the side is below 2^23.
using LookUp = std::function<void(Footprint const* footprints, std::size_t count, glm::vec4* colours)>;

enum class Family { reference, fast, beyond, upload };

struct Filter {
    std::string id;  ///< "fast_trilinear"; key of bench.json
    Title title;
    Family family;
    /// Does what can be done once for each texture, and keeps what it needs of it. All mip levels are there.
    std::function<LookUp(TextureData const& texture)> prepare;
};

/// references/exercise_03.cpp in the framework's ImageTexture: what a student writes, compiled with the same flags as
/// all others. The baseline of all ratios.
LookUp prepare_reference_nearest(TextureData const& texture);
LookUp prepare_reference_bilinear(TextureData const& texture);
LookUp prepare_reference_trilinear(TextureData const& texture);

/// The same functions with SSE2: four channels at a time, wrapped by a mask, the footprints' levels by a polynomial.
LookUp prepare_fast_nearest(TextureData const& texture);
LookUp prepare_fast_bilinear(TextureData const& texture);
LookUp prepare_fast_trilinear(TextureData const& texture);

/// Levels that are halved along u and v independently; bilinear in the four next to the two sides of the box around the
/// footprint, interpolated along both.
LookUp prepare_ripmap(TextureData const& texture);

/// `probes` (4 or 16) bilinear probes over the footprint, in the level that suits their distance.
LookUp prepare_anisotropic(TextureData const& texture, int probes);

/// Elliptical weighted average (Greene and Heckbert 1986; Heckbert, "Fundamentals of Texture Mapping and Image
/// Warping", 1989, chapter 3): all texels in the ellipse, by a Gaussian.
LookUp prepare_ewa(TextureData const& texture);

/// side x side (even) bilinear lookups of level 0, evenly over the footprint.
LookUp prepare_supersampling(TextureData const& texture, int side);

/// All of the above, in the order in which they are shown.
std::vector<Filter> const& filters();
}  // namespace testat::bench
