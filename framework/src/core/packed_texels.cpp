#include "packed_texels.h"

#include "picture_file.h"

PackedTexels::PackedTexels(int width, int height, std::shared_ptr<unsigned char const> rgba, float gamma)
    : width_(width),
      height_(height),
      rgba_(std::move(rgba)),
      color_(decoding_table(255, gamma)),
      alpha_(decoding_table(255, 1.f))
{
}

std::vector<glm::vec4> PackedTexels::unpack() const
{
    std::size_t const count = std::size_t(width_) * std::size_t(height_);
    std::vector<glm::vec4> texels;
    texels.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        texels.push_back(at(i));
    return texels;
}
