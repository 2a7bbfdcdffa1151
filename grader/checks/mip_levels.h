#pragma once
#include "checks/textures.h"
#include "envelopes/mip_levels.h"

namespace testat {
/// The exact mean of the texels of level 0 below a texel, and what float summation may be off by: at each level four
/// roundings or fewer of sums that are at most four times the largest texel. 0 on level 0 itself.
struct MipTexel {
    glm::dvec4 mean;
    double bound;
};
MipTexel mip_texel(TextureData const& texture, int level, int x, int y);
}  // namespace testat
