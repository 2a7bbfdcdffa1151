// verdict: {"loses": {"evaluate_trilinear": [2, 2]}, "says": {"evaluate_trilinear": "wrong"}, "policy": [], "mistake": {"evaluate_trilinear": "trilinear_adds_the_sides"}}
// The sum of both sides instead of the larger one.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = mip_levels[0]->getWidth();
    float const height = mip_levels[0]->getHeight();
    float const S = dudv.x * width + dudv.y * height;
    if (!(S > 1.f))
        return evaluate_bilinear(0, uv);
    float const T = std::log2(S);
    if (T >= last)
        return evaluate_bilinear(last, uv);
    int const l = (int)T;
    return glm::mix(evaluate_bilinear(l, uv), evaluate_bilinear(l + 1, uv), T - l);
}
