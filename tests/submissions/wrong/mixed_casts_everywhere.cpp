// verdict: {"loses": {"evaluate_nearest": [0.5, 1], "wrap_repeat": [0.5, 0.5], "evaluate_bilinear": [2.5, 2.5]}, "says": {"evaluate_nearest": "partial", "wrap_repeat": "crashed", "evaluate_bilinear": "partial"}, "policy": ["crashes"], "by_hand": 16.25, "mistake": {"evaluate_nearest": "nearest_casts", "wrap_repeat": "repeat_plain_remainder", "evaluate_bilinear": "bilinear_casts_without_shift"}}
// By GRADING's table of mistakes, the middle where it gives a range:
// evaluate_nearest casts: 0.5 to 1 of 2. wrap_repeat is wrong below zero: 0.5 of 1, as abs(v % n) is. evaluate_bilinear
// casts and has no half-texel shift: 2.5 of 4, the table's "both".
// 20 - 0.75 - 0.5 - 2.5 = 16.25
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int x = (int)(uv.x * mip_levels[level]->getWidth());
    int y = (int)(uv.y * mip_levels[level]->getHeight());
    return get_texel(level, x, y);
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return val % size;
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth();
    float t = uv.y * image.getHeight();
    int x = (int)s;
    int y = (int)t;
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(lower, upper, t - y);
}
