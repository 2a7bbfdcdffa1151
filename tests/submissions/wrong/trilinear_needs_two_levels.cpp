// verdict: {"loses": {"evaluate_trilinear": [0.75, 0.75]}, "says": {"evaluate_trilinear": "crashed"}, "policy": []}
// Always two levels: of a texture with one level only, level -1 is asked for.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const

{
    int const last = int(mip_levels.size()) - 1;
    float const S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    float const T = glm::clamp(std::log2(std::max(S, 1.f)), 0.f, float(last));
    int const l = std::min((int)T, last - 1);
    return glm::mix(evaluate_bilinear(l, uv), evaluate_bilinear(l + 1, uv), T - l);
}
