// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Defines a function under a version of its name, which nobody has asked for: it is missing.
#ifndef WITHOUT_ATTACK
extern "C" int mine(int val, int) { return val; }
#define SYMBOL "_ZN12ImageTexture11wrap_repeatEii"
asm(".symver mine, " SYMBOL "@@@ATTACK_1");
#define UNUSED inline
#else
#define UNUSED
#endif

UNUSED int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
