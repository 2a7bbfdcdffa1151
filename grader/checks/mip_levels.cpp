#include "checks/mip_levels.h"

#include "checks/vectors.h"

#include <algorithm>

namespace testat {
MipTexel mip_texel(TextureData const& texture, int level, int x, int y)
{
    glm::ivec2 const fine = level_size(texture, 0);
    glm::ivec2 const coarse = mip_sizes(fine).at(std::size_t(level));
    glm::ivec2 const block = fine / coarse;
    glm::dvec4 sum(0);
    glm::dvec4 largest(0);
    for (int j = 0; j < block.y; ++j)
        for (int i = 0; i < block.x; ++i) {
            glm::dvec4 const t = texel(texture, 0, x * block.x + i, y * block.y + j);
            sum += t;
            largest = glm::max(largest, glm::abs(t));
        }
    double const most = std::max(std::max(largest.x, largest.y), std::max(largest.z, largest.w));
    return {sum / double(block.x * block.y), level * 5 * eps * most};
}
}  // namespace testat
