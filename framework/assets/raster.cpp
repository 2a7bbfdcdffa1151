#include "raster.h"

#include <cglib/core/thread_pool.h>

#include <algorithm>
#include <cmath>
#include <thread>

namespace {
/// Nearest value that an 8-bit file can hold.
float to_8_bit(float value)
{
    return std::floor(glm::clamp(value, 0.f, 1.f) * 255.f + 0.5f) / 255.f;
}
}  // namespace

void for_each_row(int count, std::function<void(int)> const& row)
{
    ThreadPool pool(std::max(1, int(std::thread::hardware_concurrency())));
    pool.run(count, row);
}

Image make_image(int width, int height, std::function<glm::vec3(int x, int y)> const& color)
{
    Image image(width, height);
    for_each_row(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            glm::vec3 const c = color(x, y);
            image.setPixel(x, y, glm::vec4(to_8_bit(c.r), to_8_bit(c.g), to_8_bit(c.b), 1.f));
        }
    });
    return image;
}

glm::vec2 texel_center(int x, int y, int width, int height)
{
    return (glm::vec2(float(x), float(y)) + 0.5f) / glm::vec2(float(width), float(height));
}

float coverage(float signed_distance)
{
    return glm::clamp(0.5f - signed_distance, 0.f, 1.f);
}
