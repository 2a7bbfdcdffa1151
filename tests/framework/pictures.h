#pragma once

#include <cglib/core/image.h>

/// Every pixel differs from all others, in each channel; values are in [0, 1].
inline Image numbered_image(int width, int height)
{
    Image image(width, height);
    float const count = float(width * height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            float const value = float(i + j * width) / count;
            image.setPixel(i, j, glm::vec4(value, 1.f - value, value * value, 1.f));
        }
    return image;
}
