// verdict: {"loses": {}}
// floor(s + 0.5) - 1, and four weights.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    float s = uv.x * mip_levels[level]->getWidth();
    float t = uv.y * mip_levels[level]->getHeight();
    int x = int(std::floor(s + 0.5f)) - 1;
    int y = int(std::floor(t + 0.5f)) - 1;
    float a = s - 0.5f - x;
    float b = t - 0.5f - y;
    return (1 - a) * (1 - b) * get_texel(level, x, y) + a * (1 - b) * get_texel(level, x + 1, y) +
           (1 - a) * b * get_texel(level, x, y + 1) + a * b * get_texel(level, x + 1, y + 1);
}
