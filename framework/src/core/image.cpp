#include <cglib/core/image.h>

#include "packed_texels.h"
#include "picture_file.h"
#include "texel_memory.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace {
std::vector<glm::vec4> blank(int width, int height)
{
    cg_assert(width >= 0 && height >= 0);
    std::size_t const count = std::size_t(width) * std::size_t(height);
    std::vector<glm::vec4> texels = reserve_texels(count);
    texels.resize(count, glm::vec4(0.f));
    return texels;
}
}  // namespace

Image::Image() : is_packed_(false) {}

Image::Image(int width, int height) : width_(width), height_(height), pixels_(blank(width, height)), is_packed_(false)
{
}

Image::Image(std::shared_ptr<PackedTexels const> texels)
    : width_(texels->width()), height_(texels->height()), packed_(std::move(texels)), is_packed_(true)
{
}

Image::Image(Image const& other)
    : width_(other.width_),
      height_(other.height_),
      packed_(other.packed_),
      pixels_(other.pixels_),
      is_packed_(other.is_packed_.load())
{
}

Image::Image(Image&& other) noexcept : is_packed_(false)
{
    swap(other);
}

Image& Image::operator=(Image other) noexcept
{
    swap(other);
    return *this;
}

void Image::swap(Image& other) noexcept
{
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    is_packed_ = other.is_packed_.exchange(is_packed_);
    pixels_.swap(other.pixels_);
    packed_.swap(other.packed_);
}

Image::~Image() = default;

void Image::setSize(int width, int height)
{
    *this = Image(width, height);
}

void Image::clear(glm::vec4 const& color)
{
    std::fill(getPixels().begin(), getPixels().end(), color);
}

void Image::load(std::string const& path, float gamma)
{
    *this = read_picture(path, gamma);
}

void Image::save(std::string const& path, float gamma) const
{
    write_picture(*this, path, gamma);
}

glm::vec4 Image::texel(int i, int j) const
{
    return is_packed_.load(std::memory_order_acquire) ? packed_->at(index(i, j)) : pixels_[index(i, j)];
}

void Image::unpack() const
{
    static std::mutex mutex;
    std::lock_guard<std::mutex> const lock(mutex);
    if (!is_packed_)
        return;
    pixels_ = packed_->unpack();
    is_packed_.store(false, std::memory_order_release);
}
