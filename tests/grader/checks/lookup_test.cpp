#include "checks/lookup.h"

#include "checks/vectors.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
/// Grey texels, row by row; each level half as large.
TextureData grey(Wrap wrap, int width, int height, std::vector<std::vector<float>> const& levels)
{
    TextureData texture{static_cast<std::uint32_t>(wrap), {}};
    for (auto const& values : levels) {
        TextureData::Level level{width, height, {}};
        for (float v : values)
            level.texels.insert(level.texels.end(), 4, v);
        texture.levels.push_back(level);
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    }
    return texture;
}

TextureData row(Wrap wrap)
{
    return grey(wrap, 4, 1, {{1, 2, 4, 8}});
}

/// 2 x 2 with one level more.
TextureData square()
{
    return grey(Wrap::repeat, 2, 2, {{0, 4, 8, 12}, {100}});
}

double along_row(Wrap wrap, double s)
{
    return bilinear(row(wrap), 0, {s / 4, 0.5}).value.x;
}

double level_of(double texels)
{
    return trilinear(square(), {0.25, 0.25}, glm::dvec2(texels / 2)).value.x;
}
}  // namespace

TEST(Bilinear, IsTheTexelAtItsCentre)
{
    EXPECT_EQ(along_row(Wrap::repeat, 0.5), 1);
    EXPECT_EQ(along_row(Wrap::repeat, 2.5), 4);
    EXPECT_EQ(bilinear(square(), 0, {0.75, 0.25}).value.x, 4);
    EXPECT_EQ(bilinear(square(), 0, {0.25, 0.75}).value.x, 8);
}

TEST(Bilinear, IsTheMeanBetweenTwoCentres)
{
    EXPECT_EQ(along_row(Wrap::repeat, 1), 1.5);
    EXPECT_EQ(along_row(Wrap::repeat, 2.25), 3.5);
    EXPECT_EQ(bilinear(square(), 0, {0.5, 0.5}).value.x, 6);
}

TEST(Bilinear, FollowsTheWrapMode)
{
    EXPECT_EQ(along_row(Wrap::repeat, 0), 4.5);
    EXPECT_EQ(along_row(Wrap::clamp, 0), 1);
    EXPECT_EQ(along_row(Wrap::repeat, 4), 4.5);
    EXPECT_EQ(along_row(Wrap::clamp, 4), 8);
}

TEST(Bilinear, IsHalfWhereTheOtherHalfIsOutside)
{
    EXPECT_EQ(bilinear(grey(Wrap::zero, 2, 2, {{1, 1, 1, 1}}), 0, {0.0, 0.5}).value.x, 0.5);
    EXPECT_EQ(bilinear(grey(Wrap::zero, 2, 2, {{1, 1, 1, 1}}), 0, {0.0, 0.0}).value.x, 0.25);
}

TEST(Bilinear, GoesOnForNegativeCoordinates)
{
    for (double s : {0.3, 1.7, 3.99})
        EXPECT_NEAR(along_row(Wrap::repeat, s - 8), along_row(Wrap::repeat, s), 1e-13);
}

TEST(Bilinear, HasABoundOfAFewRoundings)
{
    double const bound = bilinear(row(Wrap::repeat), 0, {0.4, 0.5}).bound.x;
    EXPECT_GT(bound, 8 * eps * 8);
    EXPECT_LT(bound, 200 * eps * 8);
}

TEST(CoordinateError, GrowsWithTheCoordinate)
{
    EXPECT_EQ(coordinate_error(0, 8), 9 * eps);
    EXPECT_EQ(coordinate_error(-2, 8), 57 * eps);
}

TEST(Trilinear, IsLevelZeroUpToOneTexel)
{
    EXPECT_EQ(level_of(0), 0);
    EXPECT_EQ(level_of(0.25), 0);
    EXPECT_EQ(level_of(1), 0);
}

TEST(Trilinear, MixesByTheLogarithm)
{
    EXPECT_NEAR(level_of(std::sqrt(2.0)), 50, 1e-12);
    EXPECT_NEAR(level_of(std::exp2(0.25)), 25, 1e-12);
}

TEST(Trilinear, IsTheLastLevelFromThereOn)
{
    EXPECT_EQ(level_of(2), 100);
    EXPECT_EQ(level_of(1e6), 100);
}

TEST(Trilinear, TakesTheLargerSideInTexels)
{
    TextureData const wide = grey(Wrap::repeat, 4, 1, {{0, 0, 0, 0}, {4, 4}, {8}});
    EXPECT_EQ(trilinear(wide, {0.1, 0.1}, {0.5, 0}).value.x, 4);
    EXPECT_EQ(trilinear(wide, {0.1, 0.1}, {0, 2}).value.x, 4);
    EXPECT_EQ(trilinear(wide, {0.1, 0.1}, {0.25, 2}).value.x, 4);
    EXPECT_EQ(trilinear(wide, {0.1, 0.1}, {0.5, 0.5}).value.x, 4);
}

TEST(Trilinear, HasABoundThatCountsStepsBetweenLevels)
{
    auto const bound = [](double texels) { return trilinear(square(), {0.25, 0.25}, glm::dvec2(texels / 2)).bound.x; };
    EXPECT_GT(bound(1.5), 100 * 4 * eps);
    EXPECT_LT(bound(1.5), 1e-3);
    EXPECT_GT(bound(1.5), bound(0.5));
}

TEST(StoreUv, GivesTheTexelBack)
{
    float uv[2];
    store_uv({3.5, 1.5}, {8, 2}, uv);
    EXPECT_EQ(uv[0], 0.4375f);
    EXPECT_EQ(uv[1], 0.75f);
}
}  // namespace testat
