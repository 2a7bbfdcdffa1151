// verdict: {"loses": {"evaluate_trilinear": [1.25, 1.75]}, "says": {"evaluate_trilinear": "crashed"}, "policy": ["crashes"], "mistake": {"evaluate_trilinear": "trilinear_not_clamped"}}
// T is clamped at neither end.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    Image const& finest = *mip_levels[0];
    float const footprint = std::max(dudv.x * float(finest.getWidth()), dudv.y * float(finest.getHeight()));
    float const level = std::log2(footprint);
    int const finer = int(level);
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), level - float(finer));
}
