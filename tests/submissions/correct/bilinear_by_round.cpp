// verdict: {"loses": {}}
// Rounds to the next border between texels: that is where the half texel goes.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    float s = uv.x * mip_levels[level]->getWidth(), t = uv.y * mip_levels[level]->getHeight();
    int x = (int)std::round(s), y = (int)std::round(t);
    float a = s - x + 0.5f, b = t - y + 0.5f;
    return (1-b) * ((1-a) * get_texel(level, x-1, y-1) + a * get_texel(level, x, y-1)) + b * ((1-a) * get_texel(level, x-1, y) + a * get_texel(level, x, y));
}
