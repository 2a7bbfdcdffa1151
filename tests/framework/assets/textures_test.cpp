#include "textures.h"

#include "texture_files.h"

#include <gtest/gtest.h>

TEST(Textures, HaveTheSizesOfTheScenes)
{
    struct Size {
        char const* stem;
        int width;
        int height;
    };
    for (Size const& size :
         {Size{"checker", 128, 128}, Size{"stonewall_diffuse", 1024, 1024}, Size{"stonewall_normal", 1024, 1024},
          Size{"concrete_diffuse", 512, 512}, Size{"concrete_normal", 512, 512}, Size{"go_board_diffuse", 2048, 2048},
          Size{"go_board_normal", 2048, 2048}, Size{"pool_ball_1", 1024, 512}, Size{"pool_ball_15", 1024, 512},
          Size{"pool_table", 256, 256}, Size{"warehouse", 2048, 1024}, Size{"apartment", 2048, 1024}}) {
        Image const image = texture_file(size.stem);
        EXPECT_EQ(image.getWidth(), size.width) << size.stem;
        EXPECT_EQ(image.getHeight(), size.height) << size.stem;
    }
}

TEST(Textures, SameBytesOnEveryRun)
{
    EXPECT_EQ(make_concrete_diffuse().getPixels(), texture_file("concrete_diffuse").getPixels());
    EXPECT_EQ(make_concrete_normal().getPixels(), texture_file("concrete_normal").getPixels());
    EXPECT_EQ(make_pool_ball(9).getPixels(), texture_file("pool_ball_9").getPixels());
    EXPECT_EQ(make_pool_table().getPixels(), texture_file("pool_table").getPixels());
}

TEST(Textures, SurfacesTile)
{
    for (char const* stem :
         {"stonewall_diffuse", "stonewall_normal", "concrete_diffuse", "concrete_normal", "pool_table"})
        EXPECT_TRUE(tiles(texture_file(stem))) << stem;
}

TEST(Textures, NormalsAreUnit)
{
    for (char const* stem : {"stonewall_normal", "concrete_normal", "go_board_normal"})
        EXPECT_TRUE(has_unit_normals(texture_file(stem))) << stem;
}

TEST(Textures, EnvironmentsHaveNoSeam)
{
    for (char const* stem : {"warehouse", "apartment"}) {
        Image const image = texture_file(stem);
        EXPECT_LT(step_after_column(image, 2047), 0.02f) << stem;
    }
}
