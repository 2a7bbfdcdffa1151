// verdict: {"loses": {"evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_trilinear": "partial"}, "policy": []}
// Level 0 alone up to a footprint that is a little larger than one texel.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    Image const& finest = *mip_levels[0];
    float const footprint = std::max(dudv.x * float(finest.getWidth()), dudv.y * float(finest.getHeight()));
    int const last = int(mip_levels.size()) - 1;
    // A footprint of at most one texel is magnified: log2 would be negative, or minus infinity for none at all.
    if (!(footprint > 1.05f))
        return evaluate_bilinear(0, uv);
    float const level = std::log2(footprint);
    if (level >= float(last))
        return evaluate_bilinear(last, uv);
    int const finer = int(level);
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), level - float(finer));
}
