// verdict: {"loses": {"evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_trilinear": "partial"}, "policy": []}
// Clamps uv to the texture before it looks up: nothing repeats.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const

{
    glm::vec2 const inside = glm::clamp(uv, 0.f, 1.f);
    int const last = int(mip_levels.size()) - 1;
    float const S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    float const T = std::min(S > 1.f ? std::log2(S) : 0.f, float(last));
    int const l = (int)T;
    return glm::mix(evaluate_bilinear(l, inside), evaluate_bilinear(std::min(l + 1, last), inside), T - l);
}
