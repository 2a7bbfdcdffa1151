// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// Reads the picture itself and knows ZERO and REPEAT, but not CLAMP.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    Image const& image = *mip_levels[level];
    int x = (int)std::floor(uv.x * image.getWidth());
    int y = (int)std::floor(uv.y * image.getHeight());
    if (wrap_mode == ZERO && (x < 0 || y < 0 || x >= image.getWidth() || y >= image.getHeight()))
        return glm::vec4(0.f);
    return image.getPixel(wrap_repeat(x, image.getWidth()), wrap_repeat(y, image.getHeight()));
}
