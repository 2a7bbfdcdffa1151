// verdict: {"loses": {"evaluate_nearest": [1.5, 2]}, "says": {"evaluate_nearest": "wrong"}, "policy": [], "mistake": {"evaluate_nearest": "nearest_scales_by_size_minus_one"}}
// Maps (1, 1) to the last texel instead of to (W, H).
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    glm::vec2 st = uv * glm::vec2(image.getWidth() - 1, image.getHeight() - 1);
    return get_texel(level, (int)std::floor(st.x), (int)std::floor(st.y));
}
