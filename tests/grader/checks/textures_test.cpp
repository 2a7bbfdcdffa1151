#include "checks/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat {
namespace {
/// 3 x 2, texels (x, y, 0, 1).
TextureData numbered(Wrap wrap)
{
    TextureData texture{static_cast<std::uint32_t>(wrap), {{3, 2, {}}}};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            texture.levels[0].texels.insert(texture.levels[0].texels.end(), {float(x), float(y), 0, 1});
    return texture;
}

glm::dvec4 const nothing(0);
}  // namespace

TEST(Texel, IsItselfInside)
{
    for (Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::zero})
        EXPECT_EQ(texel(numbered(wrap), 0, 2, 1), glm::dvec4(2, 1, 0, 1));
}

TEST(Texel, RepeatsOutside)
{
    EXPECT_EQ(texel(numbered(Wrap::repeat), 0, 3, 2), glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(texel(numbered(Wrap::repeat), 0, -1, -1), glm::dvec4(2, 1, 0, 1));
    EXPECT_EQ(texel(numbered(Wrap::repeat), 0, -3, -2), glm::dvec4(0, 0, 0, 1));
}

TEST(Texel, IsClampedOutside)
{
    EXPECT_EQ(texel(numbered(Wrap::clamp), 0, 3, 2), glm::dvec4(2, 1, 0, 1));
    EXPECT_EQ(texel(numbered(Wrap::clamp), 0, -5, 0), glm::dvec4(0, 0, 0, 1));
}

TEST(Texel, IsZeroOutside)
{
    EXPECT_EQ(texel(numbered(Wrap::zero), 0, 3, 0), nothing);
    EXPECT_EQ(texel(numbered(Wrap::zero), 0, 0, -1), nothing);
}

TEST(TestTextures, AreThereAll)
{
    EXPECT_EQ(make_test_textures(1).size(), std::size_t(TestTexture::count));
}

TEST(TestTextures, HaveTheSizesTheirNamesSay)
{
    Textures const t = make_test_textures(1);
    EXPECT_EQ(level_size(at(t, TestTexture::coded_square), 0), glm::ivec2(16, 16));
    EXPECT_EQ(level_size(at(t, TestTexture::coded_wide), 3), glm::ivec2(4, 1));
    EXPECT_EQ(level_size(at(t, TestTexture::noise_wide), 6), glm::ivec2(1, 1));
    EXPECT_EQ(level_size(at(t, TestTexture::noise_high), 4), glm::ivec2(1, 4));
    EXPECT_EQ(level_size(at(t, TestTexture::mip_high), 0), glm::ivec2(4, 64));
    EXPECT_EQ(level_size(at(t, TestTexture::mip_single), 0), glm::ivec2(1, 1));
}

TEST(TestTextures, WrapAsTheirNamesSay)
{
    Textures const t = make_test_textures(1);
    EXPECT_EQ(at(t, TestTexture::coded_wide).wrap_mode, std::uint32_t(Wrap::repeat));
    EXPECT_EQ(at(t, TestTexture::coded_wide_clamp).wrap_mode, std::uint32_t(Wrap::clamp));
    EXPECT_EQ(at(t, TestTexture::coded_wide_zero).wrap_mode, std::uint32_t(Wrap::zero));
    EXPECT_EQ(at(t, TestTexture::stripes).wrap_mode, std::uint32_t(Wrap::repeat));
    EXPECT_EQ(at(t, TestTexture::stripes_clamp).wrap_mode, std::uint32_t(Wrap::clamp));
    EXPECT_EQ(at(t, TestTexture::stripes_zero).wrap_mode, std::uint32_t(Wrap::zero));
}

TEST(TestTextures, HaveOnlyLevelZeroWhereMipLevelsAreAsked)
{
    Textures const t = make_test_textures(1);
    for (auto i = std::size_t(TestTexture::mip_small); i < std::size_t(TestTexture::unknown); ++i)
        EXPECT_EQ(t[i].levels.size(), 1u) << i;
}

TEST(TestTextures, CodeLevelAndPlace)
{
    EXPECT_EQ(texel(at(make_test_textures(7), TestTexture::coded_wide), 1, 5, 3), glm::dvec4(1, 5, 3, 1));
}

TEST(TestTextures, HaveStripesWithSteepSteps)
{
    TextureData const t = at(make_test_textures(1), TestTexture::stripes);
    for (int i = 0; i < 16; ++i)
        EXPECT_GE(std::abs(texel(t, 0, i, 0).r - texel(t, 0, i + 1, 0).r), 0.25) << i;
}

TEST(TestTextures, HoldMeansOfWhatIsKnownAndWhatIsNot)
{
    Textures const t = make_test_textures(1, "upload");
    auto const mean = [&](int level, int x, int y) {
        return 0.5 *
               (texel(at(t, TestTexture::noise_square), level, x, y) + texel(at(t, TestTexture::unknown), level, x, y));
    };
    EXPECT_EQ(texel(at(t, TestTexture::unknown_mean_mirrored), 0, 31 - 3, 31 - 7), mean(0, 3, 7));
    EXPECT_EQ(texel(at(t, TestTexture::unknown_mean_mirrored), 2, 7 - 3, 7 - 5), mean(2, 3, 5));
    EXPECT_EQ(texel(at(t, TestTexture::unknown_mean_coarser), 0, 15 - 3, 15 - 5), mean(1, 3, 5));
    EXPECT_EQ(texel(at(t, TestTexture::unknown_mean_shifted), 0, 30 + texture_shift.x, 2 + texture_shift.y),
              mean(0, 30, 2));
    EXPECT_EQ(
        texel(at(t, TestTexture::unknown_mip_mean), 0, 63, 5),
        0.5 * (texel(at(t, TestTexture::mip_square), 0, 63, 5) + texel(at(t, TestTexture::unknown_mip), 0, 63, 5)));
}

TEST(TestTextures, DependOnTheUploadOnlyWhereTheyAreUnknown)
{
    Textures const one = make_test_textures(1, "one");
    Textures const other = make_test_textures(1, "other");
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_EQ(one[i].levels[0].texels == other[i].levels[0].texels, i < std::size_t(TestTexture::unknown_mip)) << i;
}

TEST(TestTextures, DependOnTheSeed)
{
    auto const noise = [](std::uint64_t seed) {
        return at(make_test_textures(seed), TestTexture::noise_square).levels[0].texels;
    };
    EXPECT_EQ(noise(3), noise(3));
    EXPECT_NE(noise(3), noise(4));
}
}  // namespace testat
