// verdict: {"loses": {}}
// The larger of the logarithms of both sides.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    glm::vec2 st(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    float T = std::max(std::log2(st.x), std::log2(st.y));
    float maxT = mip_levels.size() - 1;
    T = T < 0 ? 0 : T > maxT ? maxT : T;
    return glm::mix(evaluate_bilinear(std::floor(T), uv), evaluate_bilinear(std::ceil(T), uv), T - std::floor(T));
}
