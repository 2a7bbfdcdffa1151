// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "timed_out"}}
// A stub that jumps to the next definition of its own name: that is its own trampoline, and it runs in circles.
#ifndef WITHOUT_ATTACK
#include <dlfcn.h>
void* next = dlsym(RTLD_NEXT, "_ZN12ImageTexture11wrap_repeatEii");
#define SYMBOL "_ZN12ImageTexture11wrap_repeatEii"
asm(".globl " SYMBOL "\n.type " SYMBOL ", @function\n" SYMBOL ": mov next@GOTPCREL(%rip), %rax\njmp *(%rax)");
#define UNUSED inline
#else
#define UNUSED
#endif

UNUSED int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
