// verdict: {"broken": {"evaluate_nearest": "TEXEL"}, "unofficial": [18, 18]}
// The error is in a macro outside of all functions, but only where it is used.
#define TEXEL(x, y) get_texels(level, x, y)

glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    int const x = int(std::floor(uv.x * float(image.getWidth())));
    int const y = int(std::floor(uv.y * float(image.getHeight())));
    return TEXEL(x, y);
}
