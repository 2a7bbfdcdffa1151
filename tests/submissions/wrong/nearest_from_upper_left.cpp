// verdict: {"loses": {"evaluate_nearest": [2, 2]}, "says": {"evaluate_nearest": "wrong"}, "policy": []}
// Counts rows from above, as most picture formats do.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    int width = mip_levels[level]->getWidth();
    int height = mip_levels[level]->getHeight();
    int x = (int)std::floor(uv.x * width);
    int y = (int)std::floor((1.f - uv.y) * height);
    return get_texel(level, x, y);
}
