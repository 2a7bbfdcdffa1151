// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "crashed"}, "policy": ["crashes"]}
// An assertion that does not hold: uv may be negative.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    cg_assert(uv.x >= 0.f && uv.y >= 0.f);
    Image const& image = *mip_levels[level];
    return get_texel(level, (int)(uv.x * image.getWidth()), (int)(uv.y * image.getHeight()));
}
