// verdict: {"loses": {"evaluate_trilinear": [0.75, 0.75]}, "says": {"evaluate_trilinear": "partial"}, "policy": [], "mistake": {"evaluate_trilinear": "trilinear_not_clamped_below"}}
// Clamps the levels and not the fraction of T: magnified textures are mixed with level 1.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = mip_levels[0]->getWidth();
    float const height = mip_levels[0]->getHeight();
    float const S = std::max(dudv.x * width, dudv.y * height);
    float const T = std::log2(S);
    if (T >= last)
        return evaluate_bilinear(last, uv);
    int const l = (int)glm::max(0.f, std::floor(T));
    return glm::mix(evaluate_bilinear(l, uv), evaluate_bilinear(l + 1, uv), T - std::floor(T));
}
