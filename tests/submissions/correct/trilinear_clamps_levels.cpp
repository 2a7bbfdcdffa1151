// verdict: {"loses": {}}
// The two levels are clamped, log2(0) is left out; glm::fract.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    int last = (int)mip_levels.size() - 1;
    if (S <= 0)
        return evaluate_bilinear(0, uv);
    float T = std::log2(S);
    int finer = glm::clamp((int)std::floor(T), 0, last);
    int coarser = glm::clamp((int)std::ceil(T), 0, last);
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(coarser, uv), glm::fract(T));
}
