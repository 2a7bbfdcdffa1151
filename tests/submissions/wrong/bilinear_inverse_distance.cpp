// verdict: {"loses": {"evaluate_bilinear": [4, 4]}, "says": {"evaluate_bilinear": "wrong"}, "policy": []}
// Weights by inverse distance: 0/0 at texel centres.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    glm::vec2 const st = uv * glm::vec2(image.getWidth(), image.getHeight()) - 0.5f;
    glm::ivec2 const first(glm::floor(st));
    glm::vec4 sum(0.f);
    float weights = 0.f;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            float const weight = 1.f / glm::length(st - glm::vec2(first.x + i, first.y + j));
            sum += weight * get_texel(level, first.x + i, first.y + j);
            weights += weight;
        }
    return sum / weights;
}
