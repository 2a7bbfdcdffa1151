// verdict: {"loses": {"evaluate_bilinear": [3, 3]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_one_axis"}}
// Interpolates along s only.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(uv.y * image.getHeight());
    return glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
}
