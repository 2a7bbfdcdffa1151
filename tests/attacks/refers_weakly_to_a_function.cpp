// attack: {"at": "compile", "earns": [19, 19], "builds": false}
// Only mentions a function, weakly, for another to define it: it is missing.
#ifndef WITHOUT_ATTACK
#define SYMBOL "_ZN12ImageTexture11wrap_repeatEii"
asm(".data\n.weak " SYMBOL "\n.quad " SYMBOL "\n.text");
#define UNUSED inline
#else
#define UNUSED
#endif

UNUSED int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
