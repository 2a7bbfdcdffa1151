// verdict: {"loses": {"evaluate_nearest": [0.5, 1]}, "says": {"evaluate_nearest": "partial"}, "policy": [], "mistake": {"evaluate_nearest": "nearest_size_of_level_zero"}}
// Takes the size of level 0 for every level.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int x = (int)std::floor(uv.x * mip_levels[0]->getWidth());
    int y = (int)std::floor(uv.y * mip_levels[0]->getHeight());
    return get_texel(level, x, y);
}
