// attack: {"at": "compile", "earns": [20, 20], "builds": false}
// Replaces a function of the framework, as linking the exercise would refuse: it does not build.
#ifndef WITHOUT_ATTACK
glm::vec4 ImageTexture::get_texel(int, int, int) const
{
    return glm::vec4(1.f);
}
#endif
