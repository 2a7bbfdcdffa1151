// verdict: {"loses": {"evaluate_nearest": [0.5, 1]}, "says": {"evaluate_nearest": "partial"}, "policy": [], "mistake": {"evaluate_nearest": "nearest_rounds"}}
// Rounds to the nearest whole number instead of down.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int x = (int)std::round(uv.x * mip_levels[level]->getWidth());
    int y = (int)std::round(uv.y * mip_levels[level]->getHeight());
    return get_texel(level, x, y);
}
