#include "display.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

namespace viewer {
namespace {
/// The sign, which is 0, the exponent and half of a byte more: steps that are finer than those of 8 bit.
int const dropped_bits = 15;

float from_bits(std::uint32_t bits)
{
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

std::uint32_t to_bits(float value)
{
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

float factor(Exposure const& exposure)
{
    return std::exp2(exposure.stops);
}

std::uint8_t quantized(float linear, float gamma)
{
    // NaN fails the comparison.
    return linear > 0.f ? std::uint8_t(std::lround(std::min(std::pow(linear, 1.f / gamma), 1.f) * 255.f)) : 0;
}
}  // namespace

Image exposed(Image image, Exposure const& exposure)
{
    glm::vec4 const scale(glm::vec3(factor(exposure)), 1.f);
    for (glm::vec4& pixel : image.getPixels())
        pixel *= scale;
    return image;
}

DisplayCurve::DisplayCurve(Exposure const& exposure)
{
    std::uint32_t const half_a_step = 1u << (dropped_bits - 1);
    for (std::uint32_t i = 0; i < table_.size(); ++i)
        table_[i] = quantized(from_bits((i << dropped_bits) + half_a_step) * factor(exposure), exposure.gamma);
}

std::uint8_t DisplayCurve::operator()(float linear) const
{
    return linear > 0.f ? table_[to_bits(std::min(linear, FLT_MAX)) >> dropped_bits] : 0;
}

void DisplayPicture::convert(Image const& image, Tile const& tile)
{
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            glm::vec4 const& pixel = image.getPixel(x, y);
            std::uint8_t* const to = &bytes_[4 * (std::size_t(y) * std::size_t(width_) + std::size_t(x))];
            for (int c = 0; c < 3; ++c)
                to[c] = curve_(pixel[c]);
            to[3] = 255;
        }
}

void DisplayPicture::convert_all(Image const& image, Exposure const& exposure)
{
    exposure_ = exposure;
    curve_ = DisplayCurve(exposure);
    width_ = image.getWidth();
    height_ = image.getHeight();
    bytes_.resize(4 * std::size_t(width_) * std::size_t(height_));
    convert(image, {0, 0, width_, height_});
}

bool DisplayPicture::update(Image const& image, std::vector<Tile> const& parts, Exposure const& exposure)
{
    bool const is_other = exposure != exposure_ || image.getWidth() != width_ || image.getHeight() != height_;
    if (is_other)
        convert_all(image, exposure);
    else
        for (Tile const& tile : parts)
            convert(image, tile);
    return is_other || !parts.empty();
}

}  // namespace viewer
