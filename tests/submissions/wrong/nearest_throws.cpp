// verdict: {"loses": {"evaluate_nearest": [2, 2]}, "says": {"evaluate_nearest": "crashed"}, "policy": ["crashes"]}
// Counts levels from 1: std::out_of_range where there is one level only, the next level elsewhere.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels.at(level + 1);
    int x = (int)std::floor(uv.x * image.getWidth());
    int y = (int)std::floor(uv.y * image.getHeight());
    return get_texel(level + 1, x, y);
}
