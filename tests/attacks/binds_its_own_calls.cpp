// attack: {"at": "compile", "earns": [14, 16], "says": {"evaluate_bilinear": "wrong", "evaluate_trilinear": "wrong"}}
// Makes its functions call each other past the trampolines: the wrong one spoils only what is the file's own.
#ifndef WITHOUT_ATTACK
#define BOUND [[gnu::visibility("protected")]]
#else
#define BOUND
#endif

BOUND glm::vec4 ImageTexture::evaluate_bilinear(int, glm::vec2 const&) const
{
    return glm::vec4(0.25f);
}
