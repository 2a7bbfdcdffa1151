#include <cglib/core/image.h>

#include "mapped_texels.h"
#include "picture_file.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace {
std::vector<glm::vec4> blank(int width, int height)
{
    cg_assert(width >= 0 && height >= 0);
    return std::vector<glm::vec4>(std::size_t(width) * std::size_t(height), glm::vec4(0.f));
}

std::vector<glm::vec4> copy(glm::vec4 const* pixels, int width, int height)
{
    return std::vector<glm::vec4>(pixels, pixels + std::size_t(width) * std::size_t(height));
}
}  // namespace

Image::Image() : data_(nullptr) {}

Image::Image(int width, int height) : width_(width), height_(height), data_(nullptr), pixels_(blank(width, height))
{
    data_ = pixels_.data();
}

Image::Image(std::unique_ptr<MappedTexels> texels)
    : width_(texels->width()), height_(texels->height()), data_(texels->data()), mapped_(std::move(texels))
{
}

Image::Image(Image const& other)
    : width_(other.width_),
      height_(other.height_),
      data_(nullptr),
      pixels_(copy(other.data(), other.width_, other.height_))
{
    data_ = pixels_.data();
}

Image::Image(Image&& other) noexcept : data_(nullptr)
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
    data_ = other.data_.exchange(data_);
    pixels_.swap(other.pixels_);
    mapped_.swap(other.mapped_);
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

std::vector<glm::vec4>& Image::all_pixels() const
{
    if (mapped_)
        copy_mapped();
    return pixels_;
}

void Image::release()
{
    if (mapped_ && pixels_.empty())
        mapped_->release();
}

/// The mapping stays in memory: another thread may be reading it.
void Image::copy_mapped() const
{
    static std::mutex mutex;
    std::lock_guard<std::mutex> const lock(mutex);
    if (!pixels_.empty())
        return;
    pixels_ = copy(mapped_->data(), width_, height_);
    data_ = pixels_.data();
}
