// verdict: {"loses": {"evaluate_bilinear": [4, 4]}, "says": {"evaluate_bilinear": "wrong"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_exchanges_weights"}}
// The weight of a texel is the distance to it. On one colour nobody sees it.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth() - 0.5f;
    float t = uv.y * image.getHeight() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), 1 - (s - x));
    glm::vec4 upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), 1 - (s - x));
    return glm::mix(lower, upper, 1 - (t - y));
}
