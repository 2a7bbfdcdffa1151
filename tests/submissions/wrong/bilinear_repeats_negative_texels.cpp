// verdict: {"loses": {"evaluate_bilinear": [0.5, 0.5]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Negative texels are repeated whatever the wrap mode is.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    int w = mip_levels[level]->getWidth();
    int h = mip_levels[level]->getHeight();
    float s = uv.x * w - 0.5f;
    float t = uv.y * h - 0.5f;
    float s0 = std::floor(s);
    float t0 = std::floor(t);
    int x = int(s0);
    int y = int(t0);
    while (x < 0)
        x += w;
    while (y < 0)
        y += h;
    int x1 = x + 1;
    int y1 = y + 1;
    glm::vec4 upper = glm::mix(get_texel(level, x, y), get_texel(level, x1, y), s - s0);
    glm::vec4 lower = glm::mix(get_texel(level, x, y1), get_texel(level, x1, y1), s - s0);
    return glm::mix(upper, lower, t - t0);
}
