// verdict: {"loses": {"evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_trilinear": "crashed"}, "policy": []}
// Asks for the second level of a texture that has only one.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    int last = int(mip_levels.size()) - 1;
    float T = std::log2(std::max(S, 1.f));
    if (T > 0 && T >= last)
        return evaluate_bilinear(last, uv);
    int finer = int(T);
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), T - finer);
}
