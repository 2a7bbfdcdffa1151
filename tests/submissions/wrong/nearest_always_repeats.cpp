// verdict: {"loses": {"evaluate_nearest": [0.5, 1]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// Wraps uv on its own, so that the modes ZERO and CLAMP repeat, too.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    glm::vec2 const inside = uv - glm::floor(uv);
    int x = (int)(inside.x * image.getWidth());
    int y = (int)(inside.y * image.getHeight());
    return image.getPixel(std::min(x, image.getWidth() - 1), std::min(y, image.getHeight() - 1));
}
