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

Encoder make_encoder(Picture const& picture)
{
    Encoder png(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
    spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
    spng_set_option(png.get(), SPNG_IMG_COMPRESSION_LEVEL, 1);
    spng_ihdr header = {};
    header.width = std::uint32_t(picture.width);
    header.height = std::uint32_t(picture.height);
    header.color_type = SPNG_COLOR_TYPE_TRUECOLOR;
    header.bit_depth = 8;
    spng_set_ihdr(png.get(), &header);
    return png;
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
    auto const bytes = to_bytes(picture, gamma_2_2);
    Encoder const png = make_encoder(picture);
    int error = spng_encode_image(png.get(), bytes.data(), bytes.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
    std::size_t size = 0;
    std::unique_ptr<void, void (*)(void*)> buffer(error == 0 ? spng_get_png_buffer(png.get(), &size, &error) : nullptr,
                                                  std::free);
    if (error != 0)
        throw std::runtime_error(std::string("encoding a PNG: ") + spng_strerror(error));
    return {static_cast<char const*>(buffer.get()), size};
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
