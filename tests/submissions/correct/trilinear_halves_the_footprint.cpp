// verdict: {"loses": {}}
// Counts halvings instead of taking the logarithm.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    int l = 0;
    while (S >= 2 && l < (int)mip_levels.size() - 1) { S /= 2; ++l; }
    float w = S > 1 ? std::min(1.f, (float)log2(S)) : 0;
    if (l == (int)mip_levels.size() - 1) w = 0;
    return glm::mix(evaluate_bilinear(l, uv), w > 0 ? evaluate_bilinear(l+1, uv) : glm::vec4(0), w);
}
