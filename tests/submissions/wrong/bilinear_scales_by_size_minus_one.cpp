// verdict: {"loses": {"evaluate_bilinear": [3, 4]}, "says": {"evaluate_bilinear": "wrong"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_scales_by_size_minus_one"}}
// The centres of the outer texels lie at 0 and 1, as in image editors that align corners.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    glm::vec2 const st = uv * glm::vec2(image.getWidth() - 1, image.getHeight() - 1);
    int const s = int(std::floor(st.x)), t = int(std::floor(st.y));
    glm::vec2 const weight = st - glm::floor(st);
    return glm::mix(glm::mix(get_texel(level, s, t), get_texel(level, s + 1, t), weight.x),
                    glm::mix(get_texel(level, s, t + 1), get_texel(level, s + 1, t + 1), weight.x), weight.y);
}
