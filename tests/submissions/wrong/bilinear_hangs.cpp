// verdict: {"loses": {"evaluate_bilinear": [4, 4]}, "says": {"evaluate_bilinear": "timed_out"}, "policy": []}
// An endless loop: adds up weights until they are 1, which they never are.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    glm::vec4 sum(0.f);
    for (volatile float weight = 0.f; weight != 1.f; weight = weight + 0.3f)
        sum += weight * get_texel(level, int(uv.x), int(uv.y));
    return sum;
}
