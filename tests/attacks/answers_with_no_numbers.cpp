// attack: {"at": "run", "earns": [16, 16], "says": {"evaluate_bilinear": "wrong"}}
// Answers with what is no number, of which any comparison is false: that is no right answer.
#ifndef WITHOUT_ATTACK
glm::vec4 answer() { return glm::vec4(NAN, INFINITY, -NAN, 1e38f); }
#else
glm::vec4 answer() { return glm::vec4(0.f); }
#endif

glm::vec4 ImageTexture::evaluate_bilinear(int, glm::vec2 const&) const
{
    return answer();
}
