// verdict: {"loses": {"evaluate_bilinear": [1.0, 1.0]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Clamps the neighbours' coordinates to the texture instead of leaving them to get_texel. 0.5 by the unit checks, the
// rest by the picture of the plane.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth() - 0.5f;
    float t = uv.y * image.getHeight() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    int x1 = std::min(x + 1, image.getWidth() - 1);
    int y1 = std::min(y + 1, image.getHeight() - 1);
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x1, y), s - x);
    glm::vec4 upper = glm::mix(get_texel(level, x, y1), get_texel(level, x1, y1), s - x);
    return glm::mix(lower, upper, t - y);
}
