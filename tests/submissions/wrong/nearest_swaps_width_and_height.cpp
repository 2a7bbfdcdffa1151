// verdict: {"loses": {"evaluate_nearest": [1, 1.5]}, "says": {"evaluate_nearest": "partial"}, "policy": [], "mistake": {"evaluate_nearest": "nearest_swaps_width_and_height"}}
// u times the height and v times the width; nobody notices on the square checker.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int x = (int)std::floor(uv.x * mip_levels[level]->getHeight());
    int y = (int)std::floor(uv.y * mip_levels[level]->getWidth());
    return get_texel(level, x, y);
}
