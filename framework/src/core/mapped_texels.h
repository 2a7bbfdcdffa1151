#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

/// The texels of a cache file, mapped privately: pages are read when they are touched, and copied when written.
class MappedTexels {
public:
    /// A mapping of the file, or null if there is none that was made from just this source with this gamma.
    static std::unique_ptr<MappedTexels> open(std::string const& cache, std::string const& source, float gamma);

    ~MappedTexels();
    MappedTexels(MappedTexels const&) = delete;
    MappedTexels& operator=(MappedTexels const&) = delete;

    int width() const { return width_; }
    int height() const { return height_; }
    /// width() * height(), row 0 at the bottom.
    glm::vec4* data() const;

    /// Drops the pages in memory, and what was written to them.
    void release() const;

private:
    MappedTexels(void* memory, std::size_t size, int width, int height);

    void* memory_;
    std::size_t size_;
    int width_;
    int height_;
};

class Image;

/// Keeps `image`, which was loaded from `source` with this gamma, in a cache file for MappedTexels. The file appears as
/// a whole or not at all. Throws std::runtime_error naming it.
void write_texel_cache(Image const& image, std::string const& cache, std::string const& source, float gamma);
