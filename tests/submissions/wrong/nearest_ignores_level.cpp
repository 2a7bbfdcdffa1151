// verdict: {"loses": {"evaluate_nearest": [1, 1]}, "says": {"evaluate_nearest": "partial"}, "policy": [], "mistake": {"evaluate_nearest": "nearest_ignores_level"}}
// Looks into level 0 whatever the level is: invisible as long as no level but 0 is asked for.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    const auto& img = *mip_levels[0];
    int s = (int)floor(uv.x * img.getWidth());
    int t = (int)floor(uv.y * img.getHeight());
    return get_texel(0, s, t);
}
