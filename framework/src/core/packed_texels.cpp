#include "packed_texels.h"

#include "picture_file.h"
#include "texel_memory.h"

PackedTexels::PackedTexels(std::shared_ptr<TexelBytes const> bytes, float gamma)
    : bytes_(std::move(bytes)), color_(decoding_table(255, gamma)), alpha_(decoding_table(255, 1.f))
{
}

std::vector<glm::vec4> PackedTexels::unpack() const
{
    std::size_t const count = std::size_t(width()) * std::size_t(height());
    std::vector<glm::vec4> texels = reserve_texels(count);
    for (std::size_t i = 0; i < count; ++i)
        texels.push_back(at(i));
    return texels;
}
