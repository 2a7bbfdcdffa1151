// attack: {"at": "compile", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Defines one of the eleven as a number in memory that nobody can call: it crashes.
#ifndef WITHOUT_ATTACK
#define SYMBOL "_ZN12ImageTexture11wrap_repeatEii"
asm(".data\n.globl " SYMBOL "\n.type " SYMBOL ", @object\n" SYMBOL ": .quad 0\n.text");
#define UNUSED inline
#else
#define UNUSED
#endif

UNUSED int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
