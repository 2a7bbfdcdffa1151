// verdict: {"broken": {"evaluate_bilinear": "return glm::mix(lower, upper"}, "unofficial": [15.5, 16]}
// One function does not compile, and another one that does is not right.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float const s = uv.x * float(image.getWidth()) - 0.5f;
    float const t = uv.y * float(image.getHeight()) - 0.5f;
    int const x = int(std::floor(s));
    int const y = int(std::floor(t));
    glm::vec4 const lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - std::floor(s));
    glm::vec4 const upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - std::floor(s));
    return glm::mix(lower, upper, t - std::floor(t))
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return std::abs(val % size);
}
