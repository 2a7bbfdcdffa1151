// verdict: {"loses": {}}
// log2(0) is minus infinity, and max(0, -inf) is 0.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    glm::vec2 size(mip_levels[0]->getWidth(), mip_levels[0]->getHeight());
    glm::vec2 texels = dudv * size;
    float T = std::max(0.f, std::min(std::log2(std::max(texels.x, texels.y)), float(mip_levels.size()) - 1.f));
    int level = std::min(int(T), std::max(0, int(mip_levels.size()) - 2));
    if (mip_levels.size() == 1)
        return evaluate_bilinear(0, uv);
    float weight = T - level;
    return evaluate_bilinear(level, uv) * (1.f - weight) + evaluate_bilinear(level + 1, uv) * weight;
}
