// verdict: {"broken": {"evaluate_nearest": "return uv;"}, "unofficial": [18, 18]}
// Two floats cannot become four.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    (void)level;
    return uv;
}
