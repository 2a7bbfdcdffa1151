// attack: {"at": "compile", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Defines one of the eleven as another name of the next: that computes something else.
#ifndef WITHOUT_ATTACK
#define SYMBOL "_ZN12ImageTexture11wrap_repeatEii"
asm(".globl " SYMBOL "\n.type " SYMBOL ", @function\n.set " SYMBOL ", _ZN12ImageTexture10wrap_clampEii");
#define UNUSED inline
#else
#define UNUSED
#endif

UNUSED int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
