// verdict: {"loses": {"evaluate_bilinear": [3, 3]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Copied and not changed: the texel to the right stands where the one above right belongs. Right at texel centres.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    float s = uv.x * mip_levels[level]->getWidth() - 0.5f;
    float t = uv.y * mip_levels[level]->getHeight() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    float fs = s - x;
    float ft = t - y;
    glm::vec4 c00 = get_texel(level, x, y);
    glm::vec4 c10 = get_texel(level, x + 1, y);
    glm::vec4 c01 = get_texel(level, x, y + 1);
    glm::vec4 c11 = get_texel(level, x + 1, y);
    return (c00 * (1 - fs) + c10 * fs) * (1 - ft) + (c01 * (1 - fs) + c11 * fs) * ft;
}
