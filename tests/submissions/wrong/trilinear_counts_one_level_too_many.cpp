// verdict: {"loses": {"evaluate_trilinear": [0.75, 0.75]}, "says": {"evaluate_trilinear": "crashed"}, "policy": ["crashes"], "mistake": {"evaluate_trilinear": "trilinear_not_clamped_above"}}
// Takes the number of levels for the index of the last one.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size());
    float const width = mip_levels[0]->getWidth();
    float const height = mip_levels[0]->getHeight();
    float const S = std::max(dudv.x * width, dudv.y * height);
    if (!(S > 1.f))
        return evaluate_bilinear(0, uv);
    float const T = std::log2(S);
    if (T >= last)
        return evaluate_bilinear(last, uv);
    int const l = (int)T;
    return glm::mix(evaluate_bilinear(l, uv), evaluate_bilinear(l + 1, uv), T - l);
}
