// verdict: {"loses": {"evaluate_trilinear": [1.5, 2]}, "says": {"evaluate_trilinear": "wrong"}, "policy": [], "mistake": {"evaluate_trilinear": "trilinear_does_not_interpolate"}}
// Takes the finer of the two levels.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = float(mip_levels[0]->getWidth());
    float const height = float(mip_levels[0]->getHeight());
    float const S = std::max(dudv.x * width, dudv.y * height);
    if (!(S > 1.f))
        return evaluate_bilinear(0, uv);
    float const T = std::log2(S);
    if (T >= float(last))
        return evaluate_bilinear(last, uv);
    return evaluate_bilinear(int(T), uv);
}
