// verdict: {"loses": {}, "remarks": ["races"], "sanitizers": false}
// Keeps the four texels in a static array: right as long as there is one thread.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    static glm::vec4 texels[4];
    Image const& image = *mip_levels[level];
    float const s = uv.x * float(image.getWidth()) - 0.5f;
    float const t = uv.y * float(image.getHeight()) - 0.5f;
    int const x = int(std::floor(s));
    int const y = int(std::floor(t));
    for (int i = 0; i < 4; ++i)
        texels[i] = get_texel(level, x + i % 2, y + i / 2);
    glm::vec4 const lower = glm::mix(texels[0], texels[1], s - float(x));
    glm::vec4 const upper = glm::mix(texels[2], texels[3], s - float(x));
    return glm::mix(lower, upper, t - float(y));
}
