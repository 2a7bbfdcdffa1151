// verdict: {"loses": {"evaluate_bilinear": [4, 4]}, "says": {"evaluate_bilinear": "wrong"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_shifts_the_wrong_way"}}
// Adds the half texel instead of taking it away: one texel off.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    const Image& img = *mip_levels[level];
    float s = uv.x * img.getWidth() + 0.5f;
    float t = uv.y * img.getHeight() + 0.5f;
    float fs = std::floor(s), ft = std::floor(t);
    int x = (int)fs, y = (int)ft;
    float a = s - fs, b = t - ft;
    return (1 - a) * (1 - b) * get_texel(level, x, y) + a * (1 - b) * get_texel(level, x + 1, y) +
           (1 - a) * b * get_texel(level, x, y + 1) + a * b * get_texel(level, x + 1, y + 1);
}
