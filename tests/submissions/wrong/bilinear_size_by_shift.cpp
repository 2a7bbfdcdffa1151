// verdict: {"loses": {"evaluate_bilinear": [0.5, 1]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// The size of a level from level 0 by a shift: the shorter side is 0 where it should be 1.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    glm::vec2 const size(mip_levels[0]->getWidth() >> level, mip_levels[0]->getHeight() >> level);
    glm::vec2 const st = uv * size - 0.5f;
    int const s = int(std::floor(st.x)), t = int(std::floor(st.y));
    glm::vec2 const weight = st - glm::floor(st);
    return glm::mix(glm::mix(get_texel(level, s, t), get_texel(level, s + 1, t), weight.x),
                    glm::mix(get_texel(level, s, t + 1), get_texel(level, s + 1, t + 1), weight.x), weight.y);
}
