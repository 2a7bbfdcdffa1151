// verdict: {"loses": {"evaluate_bilinear": [0.5, 0.5]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Wraps on its own and reads the picture itself: the modes CLAMP and ZERO repeat, too, and DEBUG_MIP shows the texture.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    Image const& image = *mip_levels[level];
    int const w = image.getWidth();
    int const h = image.getHeight();
    float s = uv.x * w - 0.5f;
    float t = uv.y * h - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    float fs = s - x;
    float ft = t - y;
    int x0 = wrap_repeat(x, w), x1 = wrap_repeat(x + 1, w);
    int y0 = wrap_repeat(y, h), y1 = wrap_repeat(y + 1, h);
    return (1 - ft) * ((1 - fs) * image.getPixel(x0, y0) + fs * image.getPixel(x1, y0)) +
           ft * ((1 - fs) * image.getPixel(x0, y1) + fs * image.getPixel(x1, y1));
}
