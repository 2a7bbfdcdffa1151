// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// Casts instead of rounding down, on all levels but the first.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int w = mip_levels[level]->getWidth();
    int h = mip_levels[level]->getHeight();
    if (level > 0)
        return get_texel(level, int(uv.x * w), int(uv.y * h));
    return get_texel(level, int(std::floor(uv.x * w)), int(std::floor(uv.y * h)));
}
