// verdict: {"loses": {"evaluate_bilinear": [0.75, 0.75]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// A "fast floor" that adds 1024 before the cast: wrong from there on.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    float s = uv.x * mip_levels[level]->getWidth() - 0.5f;
    float t = uv.y * mip_levels[level]->getHeight() - 0.5f;
    int x = int(double(s) + 1024.0) - 1024;
    int y = int(double(t) + 1024.0) - 1024;
    glm::vec4 a = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 b = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(a, b, t - y);
}
