// verdict: {"loses": {"evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_trilinear": "partial"}, "policy": [], "mistake": {"evaluate_trilinear": "trilinear_not_clamped_above"}}
// Levels are kept inside, T is not: behind the last level the weight is above 1.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = mip_levels[0]->getWidth();
    float const height = mip_levels[0]->getHeight();
    float const S = std::max(dudv.x * width, dudv.y * height);
    if (!(S > 1.f))
        return evaluate_bilinear(0, uv);
    float const T = std::log2(S);
    int const l = std::max(0, std::min((int)T, last - 1));
    return glm::mix(evaluate_bilinear(l, uv), evaluate_bilinear(std::min(l + 1, last), uv), T - l);
}
