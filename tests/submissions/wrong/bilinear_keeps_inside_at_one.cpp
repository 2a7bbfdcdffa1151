// verdict: {"loses": {"evaluate_bilinear": [1, 1]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Clamps uv at 1, "because a texture ends there": wrong only beyond 1.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    float u = uv.x > 1.f ? 1.f : uv.x;
    float v = uv.y > 1.f ? 1.f : uv.y;
    float s = u * mip_levels[level]->getWidth() - 0.5f;
    float t = v * mip_levels[level]->getHeight() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    glm::vec4 a = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 b = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(a, b, t - y);
}
