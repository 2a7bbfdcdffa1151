// verdict: {"loses": {"evaluate_trilinear": [1.5, 2]}, "says": {"evaluate_trilinear": "wrong"}, "policy": [], "mistake": {"evaluate_trilinear": "trilinear_footprint_in_uv"}}
// dudv is not scaled to texels.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const S = std::max(dudv.x, dudv.y);
    if (!(S > 1.f))
        return evaluate_bilinear(0, uv);
    float const T = std::log2(S);
    if (T >= float(last))
        return evaluate_bilinear(last, uv);
    int const finer = int(std::floor(T));
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), T - float(finer));
}
