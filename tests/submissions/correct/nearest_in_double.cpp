// verdict: {"loses": {}}
// Everything in double.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    double s = double(uv.x) * mip_levels[level]->getWidth();
    double t = double(uv.y) * mip_levels[level]->getHeight();
    return get_texel(level, (int)std::floor(s), (int)std::floor(t));
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    double s = double(uv.x) * mip_levels[level]->getWidth() - 0.5;
    double t = double(uv.y) * mip_levels[level]->getHeight() - 0.5;
    int x = (int)std::floor(s), y = (int)std::floor(t);
    double a = s - x, b = t - y;
    glm::dvec4 sum = (1 - a) * (1 - b) * glm::dvec4(get_texel(level, x, y)) +
                     a * (1 - b) * glm::dvec4(get_texel(level, x + 1, y)) +
                     (1 - a) * b * glm::dvec4(get_texel(level, x, y + 1)) +
                     a * b * glm::dvec4(get_texel(level, x + 1, y + 1));
    return glm::vec4(sum);
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    double S = std::max(double(dudv.x) * mip_levels[0]->getWidth(), double(dudv.y) * mip_levels[0]->getHeight());
    double T = std::min(std::log2(std::max(S, 1.0)), double(mip_levels.size() - 1));
    int lower = (int)std::floor(T), upper = (int)std::ceil(T);
    double f = T - lower;
    return glm::vec4((1 - f) * glm::dvec4(evaluate_bilinear(lower, uv)) + f * glm::dvec4(evaluate_bilinear(upper, uv)));
}
