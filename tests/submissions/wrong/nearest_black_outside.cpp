// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// Treats every wrap mode as ZERO.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    if (uv.x < 0 || uv.x >= 1 || uv.y < 0 || uv.y >= 1)
        return glm::vec4(0.f);
    return get_texel(level, int(uv.x * mip_levels[level]->getWidth()), int(uv.y * mip_levels[level]->getHeight()));
}
