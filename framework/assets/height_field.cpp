#include "height_field.h"

#include "raster.h"

#include <algorithm>

namespace {
int inside(int i, int size, Border border)
{
    if (i >= 0 && i < size)
        return i;
    if (border == Border::clamp)
        return std::clamp(i, 0, size - 1);
    return i < 0 ? i + size : i - size;
}

/// The mean of 2 radius + 1 values of a line of them.
template <class Value>
std::vector<float> moving_mean(int size, int radius, Value const& value)
{
    std::vector<float> means(static_cast<std::size_t>(size));
    float sum = 0.f;
    for (int i = -radius; i < radius; ++i)
        sum += value(i);
    for (int i = 0; i < size; ++i) {
        sum += value(i + radius);
        means[std::size_t(i)] = sum / float(2 * radius + 1);
        sum -= value(i - radius);
    }
    return means;
}

/// The field blurred along x, transposed.
HeightField blurred_and_transposed(HeightField const& field, Border border, int radius)
{
    std::vector<std::vector<float>> rows(static_cast<std::size_t>(field.height()));
    for_each_row(field.height(), [&](int y) {
        rows[std::size_t(y)] = moving_mean(field.width(), radius, [&](int x) { return field.at(x, y); });
    });
    return HeightField(field.height(), field.width(), border,
                       [&](int x, int y) { return rows[std::size_t(x)][std::size_t(y)]; });
}
}  // namespace

HeightField::HeightField(int width, int height, Border border, std::function<float(int x, int y)> const& height_at)
    : width_(width), height_(height), border_(border), values_(std::size_t(width) * std::size_t(height))
{
    for_each_row(height, [&](int y) {
        for (int x = 0; x < width; ++x)
            values_[std::size_t(x) + std::size_t(y) * std::size_t(width)] = height_at(x, y);
    });
}

float HeightField::at(int x, int y) const
{
    int const i = inside(x, width_, border_);
    int const j = inside(y, height_, border_);
    return values_[std::size_t(i) + std::size_t(j) * std::size_t(width_)];
}

glm::vec2 HeightField::slope(int x, int y) const
{
    return glm::vec2(at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)) * 0.5f;
}

HeightField HeightField::blurred(int radius) const
{
    return blurred_and_transposed(blurred_and_transposed(*this, border_, radius), border_, radius);
}

Image make_normal_map(HeightField const& field, Bitangent bitangent)
{
    float const along_v = bitangent == Bitangent::along_v ? 1.f : -1.f;
    return make_image(field.width(), field.height(), [&](int x, int y) {
        glm::vec2 const slope = field.slope(x, y);
        glm::vec3 const normal = glm::normalize(glm::vec3(-slope.x, 1.f, -along_v * slope.y));
        return glm::vec3(0.5f + 0.5f * normal.x, 0.5f + 0.5f * normal.z, normal.y);
    });
}
