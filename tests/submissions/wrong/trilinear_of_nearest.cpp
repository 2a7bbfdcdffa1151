// verdict: {"loses": {"evaluate_trilinear": [1.5, 2]}, "says": {"evaluate_trilinear": "wrong"}, "policy": [], "mistake": {"evaluate_trilinear": "trilinear_of_nearest"}}
// Interpolates between levels, but looks up the nearest texel in each.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = float(mip_levels[0]->getWidth());
    float const height = float(mip_levels[0]->getHeight());
    float const S = std::max(dudv.x * width, dudv.y * height);
    if (!(S > 1.f))
        return evaluate_nearest(0, uv);
    float const T = std::log2(S);
    if (T >= float(last))
        return evaluate_nearest(last, uv);
    int const finer = int(std::floor(T));
    return glm::mix(evaluate_nearest(finer, uv), evaluate_nearest(finer + 1, uv), T - float(finer));
}
