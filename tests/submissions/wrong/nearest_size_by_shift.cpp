// verdict: {"loses": {"evaluate_nearest": [0.5, 1]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// The size of a level from level 0 by a shift: the shorter side is 0 where it should be 1.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int const w = mip_levels[0]->getWidth() >> level, h = mip_levels[0]->getHeight() >> level;
    return get_texel(level, (int)std::floor(uv.x * w), (int)std::floor(uv.y * h));
}
