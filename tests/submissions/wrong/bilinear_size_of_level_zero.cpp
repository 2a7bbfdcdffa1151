// verdict: {"loses": {"evaluate_bilinear": [2, 2]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_size_of_level_zero"}}
// Right texels, but uv are scaled by the size of level 0 on every level.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    float s = uv.x * mip_levels[0]->getWidth() - 0.5f;
    float t = uv.y * mip_levels[0]->getHeight() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    glm::vec4 a = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 b = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(a, b, t - y);
}
