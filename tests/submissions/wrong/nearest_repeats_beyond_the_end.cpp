// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// Texels beyond the end are repeated in mode CLAMP, too.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int w = mip_levels[level]->getWidth();
    int h = mip_levels[level]->getHeight();
    int x = int(std::floor(uv.x * w));
    int y = int(std::floor(uv.y * h));
    if (wrap_mode != ZERO) {
        x = x < w ? x : x % w;
        y = y < h ? y : y % h;
    }
    return get_texel(level, x, y);
}
