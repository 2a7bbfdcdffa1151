#include "report/png.h"

#include <spng.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace testat {
namespace {
/// Smallest values that are shown as 1, 2, ..., 255. Comparing with them is exact and much faster than a power.
std::array<float, 255> make_thresholds(double gamma)
{
    std::array<float, 255> thresholds{};
    for (std::size_t i = 0; i < thresholds.size(); ++i)
        thresholds[i] = float(std::pow((double(i) + 0.5) / 255, gamma));
    return thresholds;
}

std::array<float, 255> const linear = make_thresholds(1);
std::array<float, 255> const gamma_corrected = make_thresholds(2.2);

std::vector<std::uint8_t> to_bytes(Picture const& picture, bool gamma_2_2)
{
    auto const row = 3 * std::size_t(picture.width);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.rgb.size());
    for (std::size_t y = std::size_t(picture.height); y-- > 0;)
        for (std::size_t i = 0; i < row; ++i)
            bytes.push_back(to_8_bits(picture.rgb[y * row + i], gamma_2_2));
    return bytes;
}

using Encoder = std::unique_ptr<spng_ctx, void (*)(spng_ctx*)>;

Encoder make_encoder(std::uint32_t width, std::uint32_t height)
{
    Encoder png(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
    spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
    spng_set_option(png.get(), SPNG_IMG_COMPRESSION_LEVEL, 1);
    spng_ihdr header = {};
    header.width = width;
    header.height = height;
    header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
    header.bit_depth = 8;
    spng_set_ihdr(png.get(), &header);
    return png;
}

std::string encode(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> const& rgb)
{
    Encoder const png = make_encoder(width, height);
    int error = spng_encode_image(png.get(), rgb.data(), rgb.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
    std::size_t size = 0;
    std::unique_ptr<void, void (*)(void*)> buffer(error == 0 ? spng_get_png_buffer(png.get(), &size, &error) : nullptr,
                                                  std::free);
    if (error != 0)
        throw std::runtime_error(std::string("encoding a PNG: ") + spng_strerror(error));
    return {static_cast<char const*>(buffer.get()), size};
}

/// The mean of a rectangle's pixels, channel by channel.
void average(Bitmap const& from, std::uint32_t left, std::uint32_t top, std::uint32_t right, std::uint32_t bottom,
             std::uint8_t* rgba)
{
    std::array<std::uint64_t, 4> sums{};
    for (std::uint32_t y = top; y < bottom; ++y)
        for (std::size_t i = 4 * (std::size_t(y) * from.width + left); i < 4 * (std::size_t(y) * from.width + right);
             ++i)
            sums[i % 4] += from.rgba[i];
    std::uint64_t const count = std::uint64_t(right - left) * (bottom - top);
    for (std::size_t c = 0; c < 4; ++c)
        rgba[c] = static_cast<std::uint8_t>((sums[c] + count / 2) / count);
}
}  // namespace

std::uint8_t to_8_bits(float value, bool gamma_2_2)
{
    auto const& thresholds = gamma_2_2 ? gamma_corrected : linear;
    auto const above = std::partition_point(thresholds.begin(), thresholds.end(),
                                            [value](float threshold) { return !(value < threshold); });
    return static_cast<std::uint8_t>(above - thresholds.begin());
}

std::string encode_png(Picture const& picture, bool gamma_2_2)
{
    return encode(std::uint32_t(picture.width), std::uint32_t(picture.height), to_bytes(picture, gamma_2_2));
}

std::string encode_png(Bitmap const& bitmap)
{
    std::vector<std::uint8_t> rgb;
    rgb.reserve(bitmap.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < bitmap.rgba.size(); ++i)
        if (i % 4 != 3)
            rgb.push_back(bitmap.rgba[i]);
    return encode(bitmap.width, bitmap.height, rgb);
}

Bitmap shrink(Bitmap const& from, std::uint32_t longest_side)
{
    std::uint32_t const longest = std::max(from.width, from.height);
    if (longest <= longest_side)
        return from;
    auto const scaled = [&](std::uint32_t side) {
        return std::max<std::uint32_t>(1, std::uint32_t(std::uint64_t(side) * longest_side / longest));
    };
    Bitmap to{scaled(from.width), scaled(from.height), {}};
    to.rgba.resize(4 * std::size_t(to.width) * to.height);
    auto const edge = [](std::uint32_t i, std::uint32_t big, std::uint32_t small) {
        return std::uint32_t(std::uint64_t(i) * big / small);
    };
    for (std::uint32_t y = 0; y < to.height; ++y)
        for (std::uint32_t x = 0; x < to.width; ++x)
            average(from, edge(x, from.width, to.width), edge(y, from.height, to.height),
                    edge(x + 1, from.width, to.width), edge(y + 1, from.height, to.height),
                    &to.rgba[4 * (std::size_t(y) * to.width + x)]);
    return to;
}

bool is_png(std::string const& bytes)
{
    return bytes.rfind("\x89PNG\r\n\x1a\n", 0) == 0;
}

Bitmap decode_png(std::string const& bytes)
{
    constexpr std::uint32_t longest_side = 1 << 16;
    constexpr std::size_t most_bytes = std::size_t(256) << 20;
    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> const png(spng_ctx_new(0), spng_ctx_free);
    spng_set_image_limits(png.get(), longest_side, longest_side);
    spng_ihdr header = {};
    std::size_t size = 0;
    Bitmap bitmap;
    int error = spng_set_png_buffer(png.get(), bytes.data(), bytes.size());
    error = error != 0 ? error : spng_get_ihdr(png.get(), &header);
    error = error != 0 ? error : spng_decoded_image_size(png.get(), SPNG_FMT_RGBA8, &size);
    if (error == 0 && size <= most_bytes) {
        bitmap = {header.width, header.height, std::vector<std::uint8_t>(size)};
        error = spng_decode_image(png.get(), bitmap.rgba.data(), size, SPNG_FMT_RGBA8, SPNG_DECODE_TRNS);
    }
    if (error != 0 || bitmap.rgba.empty())
        throw std::invalid_argument(std::string("a PNG that cannot be read: ") +
                                    (error != 0 ? spng_strerror(error) : "too large"));
    return bitmap;
}
}  // namespace testat
