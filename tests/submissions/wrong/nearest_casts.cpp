// verdict: {"loses": {"evaluate_nearest": [0.5, 1]}, "says": {"evaluate_nearest": "partial"}, "policy": [], "mistake": {"evaluate_nearest": "nearest_casts"}}
// Conversion to int instead of floor: negative coordinates go to the next higher texel.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int x = (int)(uv.x * mip_levels[level]->getWidth());
    int y = (int)(uv.y * mip_levels[level]->getHeight());
    return get_texel(level, x, y);
}
