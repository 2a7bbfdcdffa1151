// verdict: {"loses": {"evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_trilinear": "crashed"}, "policy": [], "mistake": {"evaluate_trilinear": "trilinear_crashes_at_last_level"}}
// S = 2^last asks for the level behind the last one.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = float(mip_levels[0]->getWidth());
    float const height = float(mip_levels[0]->getHeight());
    float const S = std::max(dudv.x * width, dudv.y * height);
    if (!(S > 1.f))
        return evaluate_bilinear(0, uv);
    float const T = std::log2(S);
    if (T > float(last))
        return evaluate_bilinear(last, uv);
    int const finer = int(std::floor(T));
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), T - float(finer));
}
