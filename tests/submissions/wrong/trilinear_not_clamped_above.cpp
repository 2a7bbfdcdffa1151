// verdict: {"loses": {"evaluate_trilinear": [0.75, 0.75]}, "says": {"evaluate_trilinear": "crashed"}, "policy": ["crashes"], "mistake": {"evaluate_trilinear": "trilinear_not_clamped_above"}}
// Nothing keeps T below the last level; near the horizon it is beyond.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float const width = float(mip_levels[0]->getWidth());
    float const height = float(mip_levels[0]->getHeight());
    float const S = std::max(dudv.x * width, dudv.y * height);
    if (!(S > 1.f))
        return evaluate_bilinear(0, uv);
    float const T = std::log2(S);
    int const finer = int(std::floor(T));
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), T - float(finer));
}
