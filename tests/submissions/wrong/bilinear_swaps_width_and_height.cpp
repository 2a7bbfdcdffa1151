// verdict: {"loses": {"evaluate_bilinear": [1, 1]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_swaps_width_and_height"}}
// u times the height and v times the width: right on square textures only.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    float s = uv.x * mip_levels[level]->getHeight() - 0.5f;
    float t = uv.y * mip_levels[level]->getWidth() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    glm::vec4 a = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 b = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(a, b, t - y);
}
