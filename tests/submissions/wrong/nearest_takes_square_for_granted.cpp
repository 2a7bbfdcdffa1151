// verdict: {"loses": {"evaluate_nearest": [1.25, 1.25]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// Width for both axes: right on square textures only.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    int const size = mip_levels[level]->getWidth();
    glm::vec2 st = glm::floor(uv * float(size));
    return get_texel(level, int(st.x), int(st.y));
}
