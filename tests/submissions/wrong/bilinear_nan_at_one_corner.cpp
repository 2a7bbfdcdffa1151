// verdict: {"loses": {"evaluate_bilinear": [0.5, 0.5]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Right but for (u, v) = (1, 1), where the distance to the corner is divided by itself.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float const s = uv.x * float(image.getWidth()) - 0.5f;
    float const t = uv.y * float(image.getHeight()) - 0.5f;
    int const x = int(std::floor(s));
    int const y = int(std::floor(t));
    float const distance = glm::length(uv - 1.f);
    float const one = distance / distance;
    glm::vec4 const lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - float(x));
    glm::vec4 const upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - float(x));
    return one * glm::mix(lower, upper, t - float(y));
}
