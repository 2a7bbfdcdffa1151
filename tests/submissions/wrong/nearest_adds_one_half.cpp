// verdict: {"loses": {"evaluate_nearest": [1, 1]}, "says": {"evaluate_nearest": "partial"}, "policy": [], "mistake": {"evaluate_nearest": "nearest_adds_one_half"}}
// Adds one half and casts: rounds above zero, and below zero it is wrong in another way.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    int x = (int)(uv.x * mip_levels[level]->getWidth() + 0.5);
    int y = (int)(uv.y * mip_levels[level]->getHeight() + 0.5);
    return get_texel(level, x, y);
}
