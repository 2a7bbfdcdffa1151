// verdict: {"loses": {"evaluate_bilinear": [1, 1]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_loses_alpha"}}
// Interpolates three channels; alpha is always 1.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    // Texel values belong to texel centres, which lie at half-integer st.
    float const s = uv.x * float(image.getWidth()) - 0.5f;
    float const t = uv.y * float(image.getHeight()) - 0.5f;
    float const s0 = std::floor(s);
    float const t0 = std::floor(t);
    int const x = int(s0);
    int const y = int(t0);

    glm::vec4 const lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - s0);
    glm::vec4 const upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - s0);
    return glm::vec4(glm::vec3(glm::mix(lower, upper, t - t0)), 1.f);
}
