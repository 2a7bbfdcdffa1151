// verdict: {"loses": {"evaluate_bilinear": [2, 2]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "remarks": ["depends_on_earlier_calls"]}
// State between calls: remembers the size of the first level it has seen.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    static float const width = float(mip_levels[level]->getWidth());
    static float const height = float(mip_levels[level]->getHeight());
    float s = uv.x * width - 0.5f;
    float t = uv.y * height - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(lower, upper, t - y);
}
