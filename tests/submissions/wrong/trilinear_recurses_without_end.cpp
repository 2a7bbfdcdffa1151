// verdict: {"loses": {"evaluate_trilinear": [2, 2]}, "says": {"evaluate_trilinear": "crashed"}, "policy": ["crashes"]}
// Calls itself where it should call evaluate_bilinear: the stack runs full.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    glm::vec4 const finer = evaluate_trilinear(uv, dudv);
    glm::vec4 const coarser = evaluate_trilinear(uv, 2.f * dudv);
    return 0.5f * (finer + coarser);
}
