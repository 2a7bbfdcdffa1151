// verdict: {"loses": {"evaluate_bilinear": [1.0, 1.0]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_casts"}}
// Conversion to int instead of floor: negative weights below zero. Most of the plane has negative uv, the board has none:
// 4 * min(0.875, 1.53 / 2) is left.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth() - 0.5f;
    float t = uv.y * image.getHeight() - 0.5f;
    int x = (int)s;
    int y = (int)t;
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(lower, upper, t - y);
}
