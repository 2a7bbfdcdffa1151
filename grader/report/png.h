#pragma once
#include "model.h"

namespace testat {
/// A value as 8 bits: round(255 max(0, x)^(1/gamma)), for gamma 1 or 2.2. NaN is 255, so that it is seen.
std::uint8_t to_8_bits(float value, bool gamma_2_2);

/// An 8-bit RGB PNG, top row first, at fast compression. Throws std::runtime_error if there is no memory for it.
std::string encode_png(Picture const& picture, bool gamma_2_2);

/// 8 bits for each of four channels, top row first.
struct Bitmap {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba;
};

/// An 8-bit RGB PNG of it; what it hides does not matter.
std::string encode_png(Bitmap const& bitmap);

/// The same, smaller, so that no side is longer than that; each pixel is the mean of those it stands for.
Bitmap shrink(Bitmap const& bitmap, std::uint32_t longest_side);

/// Whether bytes begin as a PNG does.
bool is_png(std::string const& bytes);

/// A PNG of any kind. Throws std::invalid_argument if it is damaged, or has more than 64 million pixels.
Bitmap decode_png(std::string const& bytes);
}  // namespace testat
