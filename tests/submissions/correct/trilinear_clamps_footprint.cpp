// verdict: {"loses": {}}
// S is clamped to [1, size].
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float w = mip_levels[0]->getWidth(), h = mip_levels[0]->getHeight();
    float S = glm::clamp(glm::max(dudv.x * w, dudv.y * h), 1.f, glm::max(w, h));
    float T = std::log2(S);
    float f = T - std::floor(T);
    return (1 - f) * evaluate_bilinear((int)std::floor(T), uv) + f * evaluate_bilinear((int)std::ceil(T), uv);
}
