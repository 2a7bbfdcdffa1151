// verdict: {"loses": {"evaluate_nearest": [2, 2]}, "says": {"evaluate_nearest": "wrong"}, "policy": []}
// std::ceil: the texel behind the right one, everywhere.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    int s = (int)std::ceil(uv.x * mip_levels[level]->getWidth());
    int t = (int)std::ceil(uv.y * mip_levels[level]->getHeight());
    return get_texel(level, s, t);
}
