#include "texture_files.h"

#include <cglib/core/build_paths.h>

#include <cmath>

namespace {
float difference(glm::vec4 const& a, glm::vec4 const& b)
{
    return std::abs(a.g - b.g);
}
}  // namespace

Image texture_file(std::string const& stem)
{
    Image image;
    image.load(assets_directory() + "/" + stem + ".png", 1.f);
    return image;
}

float step_after_column(Image const& image, int x)
{
    float sum = 0.f;
    for (int y = 0; y < image.getHeight(); ++y)
        sum += difference(image.getPixel(x, y), image.getPixel((x + 1) % image.getWidth(), y));
    return sum / float(image.getHeight());
}

float step_after_row(Image const& image, int y)
{
    float sum = 0.f;
    for (int x = 0; x < image.getWidth(); ++x)
        sum += difference(image.getPixel(x, y), image.getPixel(x, (y + 1) % image.getHeight()));
    return sum / float(image.getWidth());
}

bool tiles(Image const& image)
{
    int const width = image.getWidth();
    int const height = image.getHeight();
    float columns = 0.f;
    float rows = 0.f;
    for (int x = 0; x < width - 1; ++x)
        columns += step_after_column(image, x) / float(width - 1);
    for (int y = 0; y < height - 1; ++y)
        rows += step_after_row(image, y) / float(height - 1);
    return step_after_column(image, width - 1) < 2.f * columns && step_after_row(image, height - 1) < 2.f * rows;
}

bool has_unit_normals(Image const& image)
{
    for (int y = 0; y < image.getHeight(); ++y)
        for (int x = 0; x < image.getWidth(); ++x) {
            glm::vec3 const normal = normal_at(image, x, y);
            if (std::abs(glm::length(normal) - 1.f) > 0.012f || normal.y <= 0.f)
                return false;
        }
    return true;
}

glm::vec3 normal_at(Image const& image, int x, int y)
{
    glm::vec4 const& texel = image.getPixel(x, y);
    return glm::vec3(2.f * texel.r - 1.f, texel.b, 2.f * texel.g - 1.f);
}
