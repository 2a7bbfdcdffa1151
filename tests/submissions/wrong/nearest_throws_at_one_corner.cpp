// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "crashed"}, "policy": []}
// An exception for (u, v) = (1, 1) only: at() where wrapping is needed.
#include <vector>

glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    std::vector<int> columns(image.getWidth());
    int const x = int(std::floor(uv.x * float(image.getWidth())));
    int const y = int(std::floor(uv.y * float(image.getHeight())));
    if (x == image.getWidth() && y == image.getHeight())
        columns.at(x) = y;
    return get_texel(level, x, y);
}
