#include <cglib/core/image.h>

#include "picture_file.h"

#include <algorithm>
#include <cmath>

namespace {
std::vector<glm::vec4> blank(int width, int height)
{
    cg_assert(width >= 0 && height >= 0);
    return std::vector<glm::vec4>(std::size_t(width) * std::size_t(height), glm::vec4(0.f));
}
}  // namespace

Image::Image(int width, int height) : width_(width), height_(height), pixels_(blank(width, height)) {}

void Image::setSize(int width, int height)
{
    *this = Image(width, height);
}

void Image::clear(glm::vec4 const& color)
{
    std::fill(pixels_.begin(), pixels_.end(), color);
}

void Image::load(std::string const& path, float gamma)
{
    *this = read_picture(path, gamma);
}

void Image::save(std::string const& path, float gamma) const
{
    write_picture(*this, path, gamma);
}
