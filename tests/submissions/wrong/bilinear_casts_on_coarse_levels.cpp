// verdict: {"loses": {"evaluate_bilinear": [0.5, 1]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Casts instead of rounding down, on all levels but the first.
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
    if (level > 0) {
        x = int(s);
        y = int(t);
        s0 = float(x);
        t0 = float(y);
    }
    int x1 = x + 1;
    int y1 = y + 1;
    glm::vec4 upper = glm::mix(get_texel(level, x, y), get_texel(level, x1, y), s - s0);
    glm::vec4 lower = glm::mix(get_texel(level, x, y1), get_texel(level, x1, y1), s - s0);
    return glm::mix(upper, lower, t - t0);
}
