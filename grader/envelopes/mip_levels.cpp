#include "envelopes/mip_levels.h"

#include "answers.h"

#include <algorithm>

namespace testat {
glm::dvec4 MipLevels::texel(int level, int x, int y) const
{
    auto const l = std::size_t(level);
    float const* rgba = &texels[4 * (first[l] + std::size_t(y) * std::size_t(sizes[l].x) + std::size_t(x))];
    return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

MipLevels read_mip_levels(Answers const& answers, std::uint32_t index)
{
    std::size_t const words = answers.group.words_per_answer;
    std::size_t const capacity = (words - MipmapLayout::header_words) / 4;
    MipLevels levels;
    std::int32_t const claimed = integer(answers, index);
    levels.count = claimed < 0 || claimed > 1000 ? 0 : std::size_t(claimed);
    std::size_t used = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(levels.count, MipmapLayout::max_levels); ++i) {
        glm::ivec2 const size(integer(answers, index, 1 + 2 * i), integer(answers, index, 2 + 2 * i));
        if (size.x < 1 || size.y < 1 || size.x > 1 << 15 || size.y > 1 << 15)
            break;
        std::size_t const count = std::size_t(size.x) * std::size_t(size.y);
        if (count > capacity - used)
            break;
        levels.sizes.push_back(size);
        levels.first.push_back(used);
        used += count;
    }
    levels.texels.resize(4 * used);
    if (used > 0)
        std::memcpy(levels.texels.data(), &answers.words[index * words + MipmapLayout::header_words], 16 * used);
    return levels;
}

std::vector<glm::ivec2> mip_sizes(glm::ivec2 size)
{
    std::vector<glm::ivec2> sizes{size};
    while (size != glm::ivec2(1)) {
        size = glm::max(size / 2, glm::ivec2(1));
        sizes.push_back(size);
    }
    return sizes;
}

std::uint32_t mip_texel_count(glm::ivec2 level_zero)
{
    std::uint32_t count = 0;
    for (auto const& size : mip_sizes(level_zero))
        count += std::uint32_t(size.x * size.y);
    return count;
}
}  // namespace testat
