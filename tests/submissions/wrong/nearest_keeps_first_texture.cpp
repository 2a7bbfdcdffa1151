// verdict: {"loses": {"evaluate_nearest": [1, 1]}, "says": {"evaluate_nearest": "partial"}, "policy": [], "remarks": ["depends_on_earlier_calls"]}
// State between calls: the picture of the first call for all.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    static Image const* image = mip_levels[level].get();
    int x = (int)std::floor(uv.x * image->getWidth());
    int y = (int)std::floor(uv.y * image->getHeight());
    return get_texel(level, x, y);
}
