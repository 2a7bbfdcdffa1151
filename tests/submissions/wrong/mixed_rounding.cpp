// verdict: {"loses": {"evaluate_nearest": [0.5, 1], "wrap_repeat": [0.5, 0.5], "evaluate_bilinear": [2, 2]}, "says": {"evaluate_nearest": "partial", "wrap_repeat": "partial", "evaluate_bilinear": "partial"}, "policy": [], "by_hand": 16.5, "mistake": {"evaluate_nearest": "nearest_rounds", "wrap_repeat": "repeat_abs", "evaluate_bilinear": "bilinear_without_shift"}}
// By GRADING's table of mistakes, the middle where it gives a range:
// evaluate_nearest rounds: 1 of 2. wrap_repeat is abs(v % n): 0.5 of 1. evaluate_bilinear has no half-texel shift: 2 of 4.
// 20 - 1 - 0.5 - 2 = 16.5
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int x = (int)std::round(uv.x * mip_levels[level]->getWidth());
    int y = (int)std::round(uv.y * mip_levels[level]->getHeight());
    return get_texel(level, x, y);
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return std::abs(val % size);
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth();
    float t = uv.y * image.getHeight();
    int x = (int)std::floor(s);
    int y = (int)std::floor(t);
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(lower, upper, t - y);
}
