#include "picture_file.h"

#include "foreign_picture.h"
#include "png.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace {
bool is_png(std::string const& path)
{
    std::string const extension = ".png";
    auto const same = [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); };
    return path.size() >= extension.size() && std::equal(extension.rbegin(), extension.rend(), path.rbegin(), same);
}

/// Both kinds of picture have their top row first; ours have it last.
template <class Convert>
Image flipped(int width, int height, Convert const& pixel_at)
{
    Image image(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            image.setPixel(i, height - 1 - j, pixel_at(4 * (std::size_t(j) * std::size_t(width) + std::size_t(i))));
    return image;
}

Image decode(Png const& png, float gamma)
{
    std::vector<float> const table = decoding_table(png.max, gamma);
    return flipped(png.width, png.height, [&](std::size_t i) {
        auto const color = [&](std::size_t c) { return table[png.value(i + c)]; };
        return glm::vec4(color(0), color(1), color(2), float(png.value(i + 3)) / float(png.max));
    });
}

Image decode(ForeignPicture const& picture, float gamma)
{
    auto const linear = [gamma](float v) { return std::pow(std::max(0.f, v), gamma); };
    return flipped(picture.width, picture.height, [&](std::size_t i) {
        float const* v = &picture.rgba[i];
        return glm::vec4(linear(v[0]), linear(v[1]), linear(v[2]), v[3]);
    });
}

/// Alpha that is 0 or 1 everywhere would only make viewers show nothing, or nothing new.
bool has_alpha(Image const& image)
{
    std::vector<glm::vec4> const& pixels = image.getPixels();
    float const first = pixels.empty() ? 1.f : pixels.front().w;
    bool const uniform =
        std::all_of(pixels.begin(), pixels.end(), [first](glm::vec4 const& p) { return p.w == first; });
    return !(uniform && (first == 0.f || first == 1.f));
}

Bytes encode(Image const& image, float gamma)
{
    Bytes bytes{image.getWidth(), image.getHeight(), has_alpha(image) ? 4 : 3, {}};
    bytes.values.reserve(image.getPixels().size() * std::size_t(bytes.channels));
    for (int j = bytes.height - 1; j >= 0; --j) {
        for (int i = 0; i < bytes.width; ++i) {
            glm::vec4 const& pixel = image.getPixel(i, j);
            for (int c = 0; c < bytes.channels; ++c)
                bytes.values.push_back(quantize(pixel[c], c == 3 ? 1.f : 1.f / gamma));
        }
    }
    return bytes;
}
}  // namespace

unsigned char quantize(float value, float exponent)
{
    // NaN fails the comparison.
    if (!(value > 0.f))
        return 0;
    float const encoded = exponent == 1.f ? value : std::pow(value, exponent);
    return static_cast<unsigned char>(std::lround(std::min(encoded, 1.f) * 255.f));
}

std::vector<float> decoding_table(int max, float gamma)
{
    std::vector<float> table(std::size_t(max) + 1);
    for (int v = 0; v <= max; ++v)
        table[std::size_t(v)] = std::pow(float(v) / float(max), gamma);
    return table;
}

Image read_picture(std::string const& path, float gamma)
{
    return is_png(path) ? decode(read_png(path), gamma) : decode(read_foreign(path), gamma);
}

void write_picture(Image const& image, std::string const& path, float gamma)
{
    Bytes const bytes = encode(image, gamma);
    is_png(path) ? write_png(bytes, path) : write_foreign(bytes, path);
}
