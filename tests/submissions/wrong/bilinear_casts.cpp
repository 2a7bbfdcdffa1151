// verdict: {"loses": {"evaluate_bilinear": [1.75, 1.75]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Conversion to int instead of floor: negative weights below zero. GRADING.md says 1; the plane alone, most of which
// has negative uv, takes its picture to 0.07: 4 * min(0.875, 1.07 / 2).
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
