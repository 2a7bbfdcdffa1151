// verdict: {"loses": {"evaluate_bilinear": [3, 3]}, "says": {"evaluate_bilinear": "partial"}, "policy": [], "mistake": {"evaluate_bilinear": "bilinear_is_nearest"}}
// The task before, once more.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    return evaluate_nearest(level, uv);
}
