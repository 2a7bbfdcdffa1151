// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// A small number is added against roundings that there are not: at its end a texel becomes the next.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    int const x = int(std::floor(uv.x * float(image.getWidth()) + 1e-4f));
    int const y = int(std::floor(uv.y * float(image.getHeight())));
    return get_texel(level, x, y);
}
