#pragma once

#include <cglib/core/assert.h>

#include <glm/glm.hpp>

#include <atomic>
#include <complex>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

class PackedTexels;

/// A picture of linear RGBA floats. Row 0 is the BOTTOM of the picture, as v grows upward.
class Image {
public:
    /// An empty image of 0 x 0 pixels.
    Image();

    /// All pixels are zero. width, height >= 0 (asserted).
    Image(int width, int height);

    /// Texels that stay packed until somebody wants a reference to one, or writes.
    explicit Image(std::shared_ptr<PackedTexels const> texels);

    Image(Image const& other);
    Image(Image&& other) noexcept;
    Image& operator=(Image other) noexcept;
    ~Image();

    /// In pixels.
    int getWidth() const { return width_; }
    /// In pixels.
    int getHeight() const { return height_; }

    /// Changes the size (asserted to be >= 0) and sets all pixels to zero.
    void setSize(int width, int height);

    /// The pixel in column i from the left and row j from the bottom, both asserted to be inside.
    glm::vec4 const& getPixel(int i, int j) const { return data()[index(i, j)]; }

    /// Like getPixel, by value: leaves packed texels packed.
    glm::vec4 texel(int i, int j) const;

    /// Like getPixel, writing.
    void setPixel(int i, int j, glm::vec4 const& pixel) { data()[index(i, j)] = pixel; }

    /// All pixels; that of column i and row j is at i + j * getWidth().
    std::vector<glm::vec4> const& getPixels() const { return all_pixels(); }
    /// Like the const one. Its size must stay as it is.
    std::vector<glm::vec4>& getPixels() { return all_pixels(); }

    /// Sets every pixel to one colour.
    void clear(glm::vec4 const& color = glm::vec4(0.f, 0.f, 0.f, 1.f));

    /// Replaces this image by the file's: rgb = (v/255)^gamma, alpha = v/255 (1 where the file has none).
    /// PNG with 8 or 16 bit, other formats where OpenImageIO was found at build time.
    /// Throws std::runtime_error naming the path.
    void load(std::string const& path, float gamma);

    /// Writes 8 bit: v = 255 max(0, rgb)^(1/gamma), rounded and clamped, NaN as 0. Alpha is linear; it is left out
    /// where it says nothing, being 0 or being 1 everywhere. Throws std::runtime_error naming the path.
    void save(std::string const& path, float gamma) const;

private:
    std::size_t index(int i, int j) const
    {
        cg_assert(i >= 0 && i < width_ && j >= 0 && j < height_);
        return std::size_t(i) + std::size_t(j) * std::size_t(width_);
    }

    glm::vec4* data() const { return all_pixels().data(); }
    std::vector<glm::vec4>& all_pixels() const
    {
        if (is_packed_.load(std::memory_order_acquire))
            unpack();
        return pixels_;
    }
    void unpack() const;
    void swap(Image& other) noexcept;

    int width_ = 0;
    int height_ = 0;
    std::shared_ptr<PackedTexels const> packed_;
    /// Empty as long as the texels are packed.
    mutable std::vector<glm::vec4> pixels_;
    mutable std::atomic<bool> is_packed_;
};

/// The bonus task of later editions. Declared for files that define it; the framework neither defines nor calls it.
struct DiscreteFourier2D {
    /// The inverse transform of a spectrum of M x N values, row-major.
    static void reconstruct(int M, int N, std::complex<float> const* spectrum, std::complex<float>* reconstruction);
};
