// verdict: {"loses": {"evaluate_bilinear": [1, 1]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Takes the nearest texel where a level is one texel wide or high, "because there are no four neighbours".
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    int const w = mip_levels[level]->getWidth();
    int const h = mip_levels[level]->getHeight();
    if (w < 2 || h < 2)
        return evaluate_nearest(level, uv);
    float s = uv.x * w - 0.5f;
    float t = uv.y * h - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    glm::vec4 a = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 b = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(a, b, t - y);
}
