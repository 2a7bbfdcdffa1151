// verdict: {"loses": {"evaluate_trilinear": [0.75, 0.75]}, "says": {"evaluate_trilinear": "crashed"}, "policy": ["crashes"], "mistake": {"evaluate_trilinear": "trilinear_not_clamped_above"}}
// Not clamped above; at() throws where the operator would read what is not there.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    Image const& finest = *mip_levels[0];
    float const footprint = std::max(dudv.x * float(finest.getWidth()), dudv.y * float(finest.getHeight()));
    // A footprint of at most one texel is magnified: log2 would be negative, or minus infinity for none at all.
    if (!(footprint > 1.f))
        return evaluate_bilinear(0, uv);
    float const level = std::log2(footprint);
    int const finer = int(level);
    bool const there = mip_levels.at(finer) && mip_levels.at(finer + 1);
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), there ? level - float(finer) : 0.f);
}
