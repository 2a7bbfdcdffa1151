#include "tile_order.h"

#include <algorithm>

namespace viewer {

std::vector<Tile> tiles_from_centre(int width, int height, int side)
{
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += side)
        for (int x = 0; x < width; x += side)
            tiles.push_back({x, y, std::min(x + side, width), std::min(y + side, height)});
    auto const eccentricity = [&](Tile const& tile) {
        long const x = tile.x0 + tile.x1 - width;
        long const y = tile.y0 + tile.y1 - height;
        return x * x + y * y;
    };
    std::stable_sort(tiles.begin(), tiles.end(),
                     [&](Tile const& a, Tile const& b) { return eccentricity(a) < eccentricity(b); });
    return tiles;
}

}  // namespace viewer
