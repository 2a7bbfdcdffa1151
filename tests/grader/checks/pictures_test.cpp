#include "checks/pictures.h"

#include "envelopes/pictures.h"
#include "grey_picture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat {
namespace {
/// Exactly this picture, up to the widening.
Envelope envelope_of(Picture const& picture)
{
    EnvelopeBuilder builder(1);
    builder.add(picture);
    return builder.finish(0);
}

Picture spoiled(Picture picture, std::size_t pixels, float value)
{
    for (std::size_t i = 0; i < pixels; ++i)
        picture.rgb[3 * i] = value;
    return picture;
}

Comparison compare_grey(std::size_t spoiled_pixels, float value = 0.6f)
{
    Picture const right = grey_picture(200, 200, 0.5f);
    return compare_picture("plane_after_c", spoiled(right, spoiled_pixels, value), envelope_of(right));
}

/// The mip levels of the checker in which the texel of one level is wrong.
Comparison compare_levels(int wrong_level)
{
    Picture const right = grey_picture(checker_side * 3 / 2, checker_side, 0.5f);
    Picture wrong = right;
    glm::ivec2 const corner = place_of_level(wrong_level).corner;
    wrong.rgb[3 * std::size_t(corner.y * right.width + corner.x)] = 0;
    return compare_picture(miplevels, wrong, envelope_of(right));
}
}  // namespace

TEST(PictureScore, IsOneUpToTheLimit)
{
    EXPECT_EQ(picture_score(0, 6, 65536), 1);
    EXPECT_EQ(picture_score(6, 6, 65536), 1);
    EXPECT_LT(picture_score(7, 6, 65536), 1);
    EXPECT_EQ(picture_score(0, 0, 65536), 1);
}

TEST(PictureScore, IsZeroIfAllAreOutside)
{
    EXPECT_EQ(picture_score(65536, 6, 65536), 0);
    EXPECT_EQ(picture_score(65536, 0, 65536), 0);
}

TEST(PictureScore, FallsWithTheLogarithm)
{
    EXPECT_NEAR(picture_score(100, 10, 1000), 0.5, 1e-12);
    for (std::size_t outside = 7; outside < 1000; ++outside)
        ASSERT_LT(picture_score(outside + 1, 6, 1000), picture_score(outside, 6, 1000)) << outside;
}

TEST(PictureScore, AllowsNothingWithLimitZero)
{
    EXPECT_LT(picture_score(1, 0, 1000), 1);
    EXPECT_LT(picture_score(2, 0, 1000), picture_score(1, 0, 1000));
}

TEST(ComparePicture, AcceptsTheExpectedOne)
{
    Comparison const same = compare_grey(0);
    EXPECT_EQ(same.outside, 0u);
    EXPECT_EQ(same.score, 1);
    EXPECT_EQ(same.rms, 0);
    EXPECT_EQ(same.max_error, 0);
}

TEST(ComparePicture, AllowsOnePixelInTenThousandButFourAtLeast)
{
    EXPECT_EQ(compare_grey(0).limit, 4u);
    EXPECT_EQ(compare_grey(4).score, 1);
    EXPECT_LT(compare_grey(5).score, 1);
    Picture const large = grey_picture(300, 300, 0.5f);
    EXPECT_EQ(compare_picture("plane_after_c", large, envelope_of(large)).limit, 9u);
}

TEST(ComparePicture, MeasuresForTheReader)
{
    Comparison const one = compare_grey(1, 1.5f);
    EXPECT_EQ(one.outside, 1u);
    EXPECT_NEAR(one.max_error, 1, 1e-6);
    EXPECT_NEAR(one.rms, std::sqrt(1 / (3 * 40000.0)), 1e-9);
}

TEST(ComparePicture, CountsWhatIsNotFinite)
{
    for (float wrong : {NAN, HUGE_VALF, -HUGE_VALF}) {
        EXPECT_EQ(compare_grey(3, wrong).outside, 3u);
        EXPECT_EQ(compare_grey(3, wrong).max_error, HUGE_VAL);
    }
    EXPECT_EQ(compare_grey(40000, NAN).score, 0);
}

TEST(ComparePicture, RefusesOtherSizes)
{
    Picture const right = grey_picture(20, 20, 0.5f);
    for (Picture const& wrong : {Picture{}, grey_picture(20, 19, 0.5f)}) {
        Comparison const c = compare_picture("plane_after_c", wrong, envelope_of(right));
        EXPECT_EQ(c.outside, 400u);
        EXPECT_EQ(c.score, 0);
    }
}

TEST(ComparePicture, AllowsAFewTexelsInLargeLevels)
{
    EXPECT_EQ(compare_levels(0).score, 1);
    EXPECT_EQ(compare_levels(3).score, 1);
}

TEST(ComparePicture, AllowsNoneInLevelsUpTo64Texels)
{
    for (int level = 4; level < checker_levels; ++level) {
        EXPECT_EQ(compare_levels(level).limit, 0u) << level;
        EXPECT_LT(compare_levels(level).score, 1) << level;
    }
}

TEST(ComparePicture, GivesNothingForMipLevelsThatAreNotAllThere)
{
    Picture const right = grey_picture(checker_side * 3 / 2, checker_side, 0.5f);
    for (int level = 0; level < checker_levels; ++level) {
        Picture wrong = right;
        LevelPlace const place = place_of_level(level);
        for (int y = 0; y < place.size.y; ++y)
            for (int x = 0; x < place.size.x; ++x)
                wrong.rgb[3 * std::size_t((place.corner.y + y) * right.width + place.corner.x + x)] = NAN;
        EXPECT_EQ(compare_picture(miplevels, wrong, envelope_of(right)).score, 0) << level;
    }
}
}  // namespace testat
