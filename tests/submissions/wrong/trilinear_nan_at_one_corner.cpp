// verdict: {"loses": {"evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_trilinear": "partial"}, "policy": []}
// Right but for (u, v) = (0, 0), where a length that is zero is divided by itself.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float const distance = glm::length(uv);
    glm::vec2 const texels = dudv * glm::vec2(mip_levels[0]->getWidth(), mip_levels[0]->getHeight());
    float const footprint = std::max(texels.x, texels.y) * (distance / distance);
    int const last = int(mip_levels.size()) - 1;
    if (footprint <= 1.f)
        return evaluate_bilinear(0, uv);
    float const level = std::log2(footprint);
    if (level >= float(last))
        return evaluate_bilinear(last, uv);
    int const finer = std::max(int(level), 0);
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), level - float(finer));
}
