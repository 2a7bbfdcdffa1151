#include "checks/mip_levels.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
TextureData grey(int width, int height, std::vector<float> const& values)
{
    TextureData texture{0, {{width, height, {}}}};
    for (float v : values)
        texture.levels[0].texels.insert(texture.levels[0].texels.end(), 4, v);
    return texture;
}
}  // namespace

TEST(MipTexel, IsExactOnLevelZero)
{
    MipTexel const right = mip_texel(grey(2, 1, {3, 5}), 0, 1, 0);
    EXPECT_EQ(right.mean.x, 5);
    EXPECT_EQ(right.bound, 0);
}

TEST(MipTexel, IsTheMeanOfItsBlock)
{
    TextureData const texture = grey(4, 2, {1, 2, 3, 4, 5, 6, 7, 8});
    EXPECT_EQ(mip_texel(texture, 1, 0, 0).mean.x, 3.5);
    EXPECT_EQ(mip_texel(texture, 1, 1, 0).mean.x, 5.5);
    EXPECT_EQ(mip_texel(texture, 2, 0, 0).mean.x, 4.5);
}

TEST(MipTexel, GoesOnAlongOneSide)
{
    TextureData const texture = grey(1, 4, {1, 2, 3, 6});
    EXPECT_EQ(mip_texel(texture, 1, 0, 1).mean.x, 4.5);
    EXPECT_EQ(mip_texel(texture, 2, 0, 0).mean.x, 3);
}
}  // namespace testat
