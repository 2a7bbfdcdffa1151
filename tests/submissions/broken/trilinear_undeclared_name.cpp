// verdict: {"broken": {"evaluate_trilinear": "float const T = std::log2(s);"}, "unofficial": [18, 18]}
// S is written in lower case.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float const S = std::max(dudv.x * float(mip_levels[0]->getWidth()), dudv.y * float(mip_levels[0]->getHeight()));
    float const T = std::log2(s);
    int const level = glm::clamp(int(std::floor(T)), 0, int(mip_levels.size()) - 1);
    return evaluate_bilinear(level, uv);
}
