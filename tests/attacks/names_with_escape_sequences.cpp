// attack: {"at": "compile", "earns": [19, 19], "builds": false}
// Lacks a function, and has one of its name with a terminal's escape sequences: they are not passed on.
#ifndef WITHOUT_ATTACK
#define NAME "\"wrap_repeat(\033]0;attacked\007\033[31m\302\233 int)\""
asm(".globl " NAME "\n" NAME ": ret");
#define HIDDEN [[gnu::visibility("hidden")]]
#else
#define HIDDEN
#endif

HIDDEN int ImageTexture::wrap_repeat(int val, int size)
{
    return (val % size + size) % size;
}
