// verdict: {"loses": {"evaluate_bilinear": [1, 1]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// Neighbours outside the texture count as black, in mode REPEAT, too: wrong at the border and beyond.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    int w = mip_levels[level]->getWidth();
    int h = mip_levels[level]->getHeight();
    float s = uv.x * w - 0.5f;
    float t = uv.y * h - 0.5f;
    int x0 = (int)std::floor(s);
    int y0 = (int)std::floor(t);
    glm::vec4 result(0.f);
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 2; i++) {
            int x = x0 + i;
            int y = y0 + j;
            if (x < 0 || x >= w || y < 0 || y >= h)
                continue;
            float weight = (1 - std::abs(s - x)) * (1 - std::abs(t - y));
            result += weight * get_texel(level, x, y);
        }
    return result;
}
