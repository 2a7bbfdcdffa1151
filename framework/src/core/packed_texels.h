#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

/// A picture of 8 bit for each channel, as its file has it.
struct TexelBytes {
    int width;
    int height;
    /// width * height texels of four bytes, row 0 at the bottom.
    std::shared_ptr<unsigned char const> rgba;
};

/// Such a picture, decoded texel by texel: a quarter of the memory of floats.
class PackedTexels {
public:
    /// rgb is decoded to (v/255)^gamma, alpha to v/255.
    PackedTexels(std::shared_ptr<TexelBytes const> bytes, float gamma);

    int width() const { return bytes_->width; }
    int height() const { return bytes_->height; }

    /// The texel at `index` = column + row * width.
    glm::vec4 at(std::size_t index) const
    {
        unsigned char const* v = bytes_->rgba.get() + 4 * index;
        return glm::vec4(color_[v[0]], color_[v[1]], color_[v[2]], alpha_[v[3]]);
    }

    /// All texels.
    std::vector<glm::vec4> unpack() const;

private:
    std::shared_ptr<TexelBytes const> bytes_;
    std::vector<float> color_;
    std::vector<float> alpha_;
};

/// The bytes of the PNG `source` as they are in a cache file, mapped into memory; null if the file is missing, damaged,
/// or was made of another file than `source` is now.
std::shared_ptr<TexelBytes const> open_texel_cache(std::string const& cache, std::string const& source);

/// The bytes of a PNG; null if it has more than 8 bit for each channel. Throws std::runtime_error naming the path.
std::shared_ptr<TexelBytes const> decode_texels(std::string const& png);

/// Decodes the PNG `source`, which has 8 bit for each channel, into a cache file, which appears as a whole or not at
/// all. Throws std::runtime_error naming what cannot be read or written.
void write_texel_cache(std::string const& cache, std::string const& source);
