// verdict: {"loses": {"evaluate_trilinear": [2, 2]}, "says": {"evaluate_trilinear": "wrong"}, "policy": [], "remarks": ["depends_on_earlier_calls"]}
// State between calls: the size of the first texture for all of them.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const

{
    static float const width = float(mip_levels[0]->getWidth());
    static float const height = float(mip_levels[0]->getHeight());
    int const last = int(mip_levels.size()) - 1;
    float const T = std::log2(std::max(std::max(dudv.x * width, dudv.y * height), 1.f));
    int const a = std::min(int(T), last);
    int const b = std::min(a + 1, last);
    return glm::mix(evaluate_bilinear(a, uv), evaluate_bilinear(b, uv), T - std::floor(T));
}
