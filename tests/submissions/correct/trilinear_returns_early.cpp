// verdict: {"loses": {}}
// Early returns on T and on ceil(T), one look-up where T is whole; modf.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    float T = S == 0 ? 0 : std::log2(S);
    if (T <= 0)
        return evaluate_bilinear(0, uv);
    if (std::ceil(T) > mip_levels.size() - 1)
        return evaluate_bilinear(mip_levels.size() - 1, uv);
    if (std::floor(T) == T)
        return evaluate_bilinear((int)T, uv);
    float whole;
    float f = std::modf(T, &whole);
    return glm::mix(evaluate_bilinear((int)whole, uv), evaluate_bilinear((int)whole + 1, uv), f);
}
