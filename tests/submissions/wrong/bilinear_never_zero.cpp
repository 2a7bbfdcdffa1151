// verdict: {"loses": {"evaluate_bilinear": [0.5, 0.5]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Wraps on its own, and knows CLAMP and REPEAT, but not ZERO.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth() - 0.5f;
    float t = uv.y * image.getHeight() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    int xs[2], ys[2];
    for (int i = 0; i < 2; i++) {
        xs[i] = wrap_mode == CLAMP ? wrap_clamp(x + i, image.getWidth()) : wrap_repeat(x + i, image.getWidth());
        ys[i] = wrap_mode == CLAMP ? wrap_clamp(y + i, image.getHeight()) : wrap_repeat(y + i, image.getHeight());
    }
    glm::vec4 below = glm::mix(image.getPixel(xs[0], ys[0]), image.getPixel(xs[1], ys[0]), s - x);
    glm::vec4 above = glm::mix(image.getPixel(xs[0], ys[1]), image.getPixel(xs[1], ys[1]), s - x);
    return glm::mix(below, above, t - y);
}
