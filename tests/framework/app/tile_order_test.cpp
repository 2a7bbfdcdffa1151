#include <viewer/tile_order.h>

#include <gtest/gtest.h>

#include <algorithm>

TEST(TileOrder, TilesCoverEachPixelOnce)
{
    int const width = 70;
    int const height = 33;
    std::vector<int> covered(std::size_t(width * height), 0);
    for (Tile const& tile : viewer::tiles_from_centre(width, height, 16))
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x)
                ++covered.at(std::size_t(y * width + x));
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), width * height);
}

TEST(TileOrder, BeginsInTheCentre)
{
    Tile const first = viewer::tiles_from_centre(96, 96, 32).front();
    EXPECT_EQ(first.x0, 32);
    EXPECT_EQ(first.y0, 32);
}
