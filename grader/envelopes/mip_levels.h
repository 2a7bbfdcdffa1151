#pragma once
#include "model.h"

#include <glm/glm.hpp>

namespace testat {
/// Mip levels as an answer claims them; sizes are only those whose texels the answer really holds.
struct MipLevels {
    std::size_t count = 0;           ///< levels claimed
    std::vector<glm::ivec2> sizes;   ///< of the levels that are there, each side at least 1
    std::vector<std::size_t> first;  ///< where each level's texels begin
    std::vector<float> texels;       ///< RGBA

    glm::dvec4 texel(int level, int x, int y) const;
};

/// Reads an answer laid out as MipmapLayout. Claims that do not fit are cut off.
MipLevels read_mip_levels(Answers const& answers, std::uint32_t index);

/// Sizes from level 0 down to 1 x 1; each side halves and is at least 1.
std::vector<glm::ivec2> mip_sizes(glm::ivec2 level_zero);

/// Texels of all these levels.
std::uint32_t mip_texel_count(glm::ivec2 level_zero);
}  // namespace testat
