// verdict: {"loses": {"evaluate_bilinear": [4, 4]}, "says": {"evaluate_bilinear": "wrong"}, "policy": []}
// The mean of the four texels, whatever the distance.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    float s = uv.x * mip_levels[level]->getWidth() - 0.5f;
    float t = uv.y * mip_levels[level]->getHeight() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    return (get_texel(level, x, y) + get_texel(level, x + 1, y) + get_texel(level, x, y + 1) +
            get_texel(level, x + 1, y + 1)) / 4.f;
}
