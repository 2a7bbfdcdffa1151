// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// Takes the absolute value of uv "so that the index does not become negative".
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    float u = std::abs(uv.x);
    float v = std::abs(uv.y);
    int s = int(u * mip_levels[level]->getWidth());
    int t = int(v * mip_levels[level]->getHeight());
    return get_texel(level, s, t);
}
