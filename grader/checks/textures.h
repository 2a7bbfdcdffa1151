#pragma once
#include "protocol/request.h"

#include <glm/glm.hpp>

#include <functional>
#include <string_view>

namespace testat {
/// The textures of the unit checks, in the order in which requests send them. "Noise" has no symmetry, and its levels
/// are independent of each other, so that a wrong level, axis or neighbour always shows.
enum class TestTexture : std::uint32_t {
    coded_square,           ///< 16 x 16, repeat; the colour of a texel is (level, x, y, 1)
    coded_wide,             ///< 32 x 8, repeat, the same
    coded_wide_zero,        ///< 32 x 8, zero outside, the same
    coded_wide_clamp,       ///< 32 x 8, clamp, the same
    constant,               ///< 8 x 8, one colour on every level, alpha 1
    noise_square,           ///< 32 x 32, repeat, alpha 1
    noise_wide,             ///< 64 x 16, repeat
    noise_high,             ///< 16 x 64, repeat
    stripes,                ///< 16 x 16, repeat; r and g change along s only, b along t only, alpha 1
    stripes_clamp,          ///< 16 x 16, clamp, the same
    stripes_zero,           ///< 16 x 16, zero outside, the same
    noise_long,             ///< 512 x 2, repeat: ten levels, more than any other
    mip_small,              ///< 8 x 8, level 0 only, as all that follow
    mip_square,             ///< 64 x 64
    mip_wide,               ///< 32 x 8
    mip_high,               ///< 4 x 64
    mip_row,                ///< 16 x 1
    mip_column,             ///< 1 x 16
    mip_pair,               ///< 2 x 1
    mip_single,             ///< 1 x 1
    mip_long,               ///< 1 x 1024, zero outside, colours from -2 to 4
    mip_flat,               ///< 1024 x 1, the same
    bright,                 ///< 32 x 32, colours from -2 to 4, alpha 1
    unknown_mip,            ///< 64 x 64; depends on the upload, as all that follow
    unknown_mip_mean,       ///< the mean of mip_square and unknown_mip, texel by texel
    unknown_mip_wide,       ///< 16 x 4
    unknown_mip_high,       ///< 2 x 16
    unknown,                ///< 32 x 32, all levels, as all that follow unless they say something else
    unknown_mean_mirrored,  ///< the mean of noise_square and unknown, mirrored along both axes
    unknown_mean_coarser,   ///< the same from level 1 on: 16 x 16
    unknown_mean_shifted,   ///< the mean again, each level moved cyclically by `texture_shift` texels
    count
};

/// Wrap modes as the framework numbers them.
enum class Wrap : std::uint32_t { repeat = 0, clamp = 1, zero = 2 };

constexpr glm::ivec2 texture_shift(11, 5);

using Textures = std::vector<TextureData>;

/// All of TestTexture. The same seed gives the same bytes; those that are unknown depend on the upload's SHA-256, too.
Textures make_test_textures(std::uint64_t seed, std::string_view upload_sha256 = "");

inline TextureData const& at(Textures const& textures, TestTexture which)
{
    return textures[static_cast<std::uint32_t>(which)];
}

/// The colour of a texel.
using Colour = std::function<glm::vec4(int level, int x, int y)>;

/// All levels down to 1 x 1, each side half as long as before and at least 1.
TextureData with_levels(int width, int height, Wrap wrap, Colour const& colour);

/// (level, x, y, 1)
glm::vec4 coded(int level, int x, int y);

/// Size of a level.
glm::ivec2 level_size(TextureData const& texture, int level);

/// What get_texel of the framework gives for any x and y: wrapped by the texture's mode.
glm::dvec4 texel(TextureData const& texture, int level, int x, int y);
}  // namespace testat
