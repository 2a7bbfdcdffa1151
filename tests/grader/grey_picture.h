#pragma once
#include "model.h"

namespace testat {
/// All values the same.
inline Picture grey_picture(int width, int height, float value)
{
    return {width, height, std::vector<float>(3 * std::size_t(width) * std::size_t(height), value)};
}
}  // namespace testat
