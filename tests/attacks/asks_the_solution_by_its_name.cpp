// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Looks up its own function in every scope and asks the one found: that is the trampoline, which leads back.
#ifndef WITHOUT_ATTACK
#include <dlfcn.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    for (void* scope : {RTLD_DEFAULT, RTLD_NEXT})
        if (void* const found = dlsym(scope, "_ZN12ImageTexture11wrap_repeatEii"))
            return reinterpret_cast<int (*)(int, int)>(found)(val, size) + 0 * val;
#endif
    return 0;
}
