// attack: {"at": "compile", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Lacks a function; a symbol with a line break in its name makes the list of symbols say otherwise: it is missing.
#ifndef WITHOUT_ATTACK
#define LINE "\"x\n0000000000000000 T _ZN12ImageTexture11wrap_repeatEii\""
asm(".globl " LINE "\n" LINE ": ret");
#define HIDDEN [[gnu::visibility("hidden")]]
#else
#define HIDDEN
#endif

HIDDEN int ImageTexture::wrap_repeat(int val, int size)
{
    return (val % size + size) % size;
}
