#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

/// A picture of 8 bit for each channel, decoded texel by texel: a quarter of the memory of floats.
class PackedTexels {
public:
    /// `rgba` holds width * height texels of four bytes, row 0 at the bottom. rgb is decoded to (v/255)^gamma, alpha to
    /// v/255.
    PackedTexels(int width, int height, std::shared_ptr<unsigned char const> rgba, float gamma);

    int width() const { return width_; }
    int height() const { return height_; }

    /// The texel at `index` = column + row * width.
    glm::vec4 at(std::size_t index) const
    {
        unsigned char const* v = rgba_.get() + 4 * index;
        return glm::vec4(color_[v[0]], color_[v[1]], color_[v[2]], alpha_[v[3]]);
    }

    /// All texels.
    std::vector<glm::vec4> unpack() const;

private:
    int width_;
    int height_;
    std::shared_ptr<unsigned char const> rgba_;
    std::vector<float> color_;
    std::vector<float> alpha_;
};

/// The bytes of the PNG `source` as they are in a cache file, mapped into memory; null if the file is missing, damaged,
/// or was made of another file than `source` is now.
std::shared_ptr<PackedTexels const> open_texel_cache(std::string const& cache, std::string const& source, float gamma);

/// Decodes the PNG `source`, which has 8 bit for each channel, into a cache file, which appears as a whole or not at
/// all. Throws std::runtime_error naming what cannot be read or written.
void write_texel_cache(std::string const& cache, std::string const& source);
