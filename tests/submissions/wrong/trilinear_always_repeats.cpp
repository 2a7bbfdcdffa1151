// verdict: {"loses": {"evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_trilinear": "partial"}, "policy": []}
// Repeats the texture whatever the wrap mode is.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    int last = int(mip_levels.size()) - 1;
    float T = std::log2(std::max(S, 1.f));
    glm::vec2 inside = uv - glm::floor(uv);
    if (T >= last)
        return evaluate_bilinear(last, inside);
    int finer = int(T);
    return glm::mix(evaluate_bilinear(finer, inside), evaluate_bilinear(finer + 1, inside), T - finer);
}
