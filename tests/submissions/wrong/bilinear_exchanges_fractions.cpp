// verdict: {"loses": {"evaluate_bilinear": [3, 3]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_exchanges_weights"}}
// Along s with the fraction of t, and along t with that of s. Right at texel centres.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    float s = uv.x * mip_levels[level]->getWidth() - 0.5f;
    float t = uv.y * mip_levels[level]->getHeight() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    float fs = s - x;
    float ft = t - y;
    glm::vec4 below = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), ft);
    glm::vec4 above = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), ft);
    return glm::mix(below, above, fs);
}
