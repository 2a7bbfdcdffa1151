// verdict: {"loses": {"evaluate_bilinear": [0.5, 0.5]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_off_at_negative_centres"}}
// A floor of one's own that is one too low for negative whole numbers: wrong exactly at texel centres below zero.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    float s = uv.x * mip_levels[level]->getWidth() - 0.5f;
    float t = uv.y * mip_levels[level]->getHeight() - 0.5f;
    int x = s < 0 ? int(s) - 1 : int(s);
    int y = t < 0 ? int(t) - 1 : int(t);
    float fs = s - std::floor(s);
    float ft = t - std::floor(t);
    return glm::mix(glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), fs),
                    glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), fs), ft);
}
