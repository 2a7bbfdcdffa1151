// attack: {"at": "compile", "earns": [19, 19], "builds": false}
// An indirect function, whose resolver would look for the solution: no such function is taken.
#ifndef WITHOUT_ATTACK
#include <dlfcn.h>
extern "C" void* resolve() { return dlsym(RTLD_DEFAULT, "_ZN12ImageTexture11wrap_repeatEii"); }
#define SYMBOL "_ZN12ImageTexture11wrap_repeatEii"
asm(".globl " SYMBOL "\n.type " SYMBOL ", @gnu_indirect_function\n.set " SYMBOL ", resolve");
#define UNUSED inline
#else
#define UNUSED
#endif

UNUSED int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
