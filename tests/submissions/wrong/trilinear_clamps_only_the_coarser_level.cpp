// verdict: {"loses": {"evaluate_trilinear": [0.5, 1.5]}, "says": {"evaluate_trilinear": "crashed"}, "policy": ["crashes"], "mistake": {"evaluate_trilinear": "trilinear_not_clamped_above"}}
// Of the two levels only the coarser one is clamped: a footprint of twice the texture's size asks for one that is not there.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    Image const& finest = *mip_levels[0];
    float const footprint = std::max(dudv.x * float(finest.getWidth()), dudv.y * float(finest.getHeight()));
    if (!(footprint > 1.f))
        return evaluate_bilinear(0, uv);
    float const level = std::log2(footprint);
    int const finer = int(level);
    int const coarser = std::min(finer + 1, int(mip_levels.size()) - 1);
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(coarser, uv), level - float(finer));
}
