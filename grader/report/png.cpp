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
}  // namespace testat
