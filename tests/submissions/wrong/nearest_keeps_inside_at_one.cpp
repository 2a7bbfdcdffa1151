// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// Keeps the index below the size "because u may be 1", and so clamps whatever lies beyond 1.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    const Image& image = *mip_levels[level];
    int x = (int)std::floor(uv.x * image.getWidth());
    int y = (int)std::floor(uv.y * image.getHeight());
    if (x >= image.getWidth())
        x = image.getWidth() - 1;
    if (y >= image.getHeight())
        y = image.getHeight() - 1;
    return get_texel(level, x, y);
}
