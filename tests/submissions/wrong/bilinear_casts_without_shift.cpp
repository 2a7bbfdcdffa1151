// verdict: {"loses": {"evaluate_bilinear": [2.5, 2.5]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_casts_without_shift"}}
// Without the half-texel shift, and with a conversion to int instead of floor.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth();
    float t = uv.y * image.getHeight();
    int x = (int)s;
    int y = (int)t;
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(lower, upper, t - y);
}
