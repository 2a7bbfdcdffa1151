// verdict: {"loses": {"evaluate_nearest": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial"}, "policy": []}
// A cast, corrected only where both coordinates are negative.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const

{
    float s = uv.x * mip_levels[level]->getWidth();
    float t = uv.y * mip_levels[level]->getHeight();
    int x = (int)s;
    int y = (int)t;
    if (s < 0 && t < 0) {
        x--;
        y--;
    }
    return get_texel(level, x, y);
}
