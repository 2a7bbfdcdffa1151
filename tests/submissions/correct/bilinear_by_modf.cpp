// verdict: {"loses": {}}
// modf, with its sign mended case by case.
static void split(float value, int* whole, float* fraction)
{
    float integral;
    *fraction = std::modf(value, &integral);
    *whole = int(integral);
    if (*fraction < 0) {
        *fraction += 1;
        *whole -= 1;
    }
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    int x, y;
    float a, b;
    split(uv.x * mip_levels[level]->getWidth() - 0.5f, &x, &a);
    split(uv.y * mip_levels[level]->getHeight() - 0.5f, &y, &b);
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), a);
    glm::vec4 upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), a);
    return glm::mix(lower, upper, b);
}
