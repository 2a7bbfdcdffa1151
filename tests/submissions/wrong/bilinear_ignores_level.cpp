// verdict: {"loses": {"evaluate_bilinear": [2, 2]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_ignores_level"}}
// Looks into level 0 whatever the level is.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    const Image& img = *mip_levels[0];
    float s = uv.x * img.getWidth() - 0.5f;
    float t = uv.y * img.getHeight() - 0.5f;
    int x = (int)std::floor(s), y = (int)std::floor(t);
    float a = s - std::floor(s), b = t - std::floor(t);
    return (1 - a) * (1 - b) * get_texel(0, x, y) + a * (1 - b) * get_texel(0, x + 1, y) +
           (1 - a) * b * get_texel(0, x, y + 1) + a * b * get_texel(0, x + 1, y + 1);
}
