#include "textures.h"

#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace {
int const size = 128;

/// FNV-1a of the bytes that are written to the file.
std::uint64_t fingerprint(Image const& image)
{
    std::uint64_t hash = 14695981039346656037u;
    for (glm::vec4 const& pixel : image.getPixels())
        for (int c = 0; c < 3; ++c)
            hash = (hash ^ std::uint64_t(std::lround(pixel[c] * 255.f))) * 1099511628211u;
    return hash;
}

/// The share of texels that differ from those at another place, where(x, y).
template <class Where>
float difference(Image const& image, Where const& where)
{
    int different = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            glm::ivec2 const other = where(x, y);
            different += image.getPixel(x, y) != image.getPixel(other.x, other.y);
        }
    return float(different) / float(size * size);
}

/// The mean step between columns x and x + 1.
float step_between_columns(Image const& image, int x)
{
    float sum = 0.f;
    for (int y = 0; y < size; ++y)
        sum += std::abs(image.getPixel((x + 1) % size, y).r - image.getPixel(x, y).r);
    return sum / float(size);
}
}  // namespace

TEST(Checker, SameBytesOnEveryMachine)
{
    Image const image = make_checker();
    EXPECT_EQ(image.getWidth(), size);
    EXPECT_EQ(image.getHeight(), size);
    EXPECT_EQ(fingerprint(image), 13237670770483447100u);
    EXPECT_EQ(image.getPixels(), make_checker().getPixels());
}

TEST(Checker, HasNoSymmetry)
{
    int const last = size - 1;
    Image const image = make_checker();
    EXPECT_GT(difference(image, [&](int x, int y) { return glm::ivec2(last - x, y); }), 0.9f);
    EXPECT_GT(difference(image, [&](int x, int y) { return glm::ivec2(x, last - y); }), 0.9f);
    EXPECT_GT(difference(image, [&](int x, int y) { return glm::ivec2(y, x); }), 0.9f);
    EXPECT_GT(difference(image, [&](int x, int y) { return glm::ivec2(last - y, x); }), 0.9f);
    EXPECT_GT(difference(image, [&](int x, int y) { return glm::ivec2(last - x, last - y); }), 0.9f);
}

TEST(Checker, NeighboursAndFieldsDiffer)
{
    Image const image = make_checker();
    EXPECT_GT(difference(image, [](int x, int y) { return glm::ivec2((x + 1) % size, y); }), 0.9f);
    EXPECT_GT(difference(image, [](int x, int y) { return glm::ivec2((x + 32) % size, y); }), 0.9f);
}

TEST(Checker, BorderIsABorderOfFieldsLikeAllOthers)
{
    Image const image = make_checker();
    EXPECT_NEAR(step_between_columns(image, size - 1), step_between_columns(image, 63), 0.1f);
    EXPECT_LT(step_between_columns(image, 40), 0.15f);
}
