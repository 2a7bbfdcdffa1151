#pragma once
#include "model.h"

namespace testat {
/// A value as 8 bits: round(255 max(0, x)^(1/gamma)), for gamma 1 or 2.2. NaN is 255, so that it is seen.
std::uint8_t to_8_bits(float value, bool gamma_2_2);

/// An 8-bit RGB PNG, top row first, at fast compression. Throws std::runtime_error if there is no memory for it.
std::string encode_png(Picture const& picture, bool gamma_2_2);
}  // namespace testat
