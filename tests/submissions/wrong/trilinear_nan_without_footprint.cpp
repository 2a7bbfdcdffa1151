// verdict: {"loses": {"evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_trilinear": "partial"}, "policy": [], "mistake": {"evaluate_trilinear": "trilinear_nan_without_footprint"}}
// dudv = 0: log2 gives minus infinity, and its fraction NaN.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = float(mip_levels[0]->getWidth());
    float const height = float(mip_levels[0]->getHeight());
    float const S = std::max(dudv.x * width, dudv.y * height);
    float const T = std::log2(S);
    int const finer = int(glm::clamp(std::floor(T), 0.f, float(last)));
    int const coarser = int(glm::clamp(std::ceil(T), 0.f, float(last)));
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(coarser, uv), T - std::floor(T));
}
