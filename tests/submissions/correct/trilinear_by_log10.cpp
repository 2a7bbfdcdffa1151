// verdict: {"loses": {}}
// log10 over log10(2).
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    float T = std::log10(S) / 0.30103f;
    T = std::min(std::max(T, 0.f), mip_levels.size() - 1.f);
    int l = T; float w = T - l;
    glm::vec4 c = (1 - w) * evaluate_bilinear(l, uv);
    if (w > 0) c += w * evaluate_bilinear(l + 1, uv);
    return c;
}
