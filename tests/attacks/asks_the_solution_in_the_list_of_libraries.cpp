// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Goes through all loaded libraries and asks each for the function: where it is not its own, it aborts.
#ifndef WITHOUT_ATTACK
#include <dlfcn.h>
#include <link.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    void* const trampoline = dlsym(RTLD_DEFAULT, "_ZN12ImageTexture11wrap_repeatEii");
    for (link_map* library = _r_debug.r_map; library != nullptr; library = library->l_next)
        if (void* const loaded = dlopen(library->l_name, RTLD_NOW | RTLD_NOLOAD))
            if (void* const found = dlsym(loaded, "_ZN12ImageTexture11wrap_repeatEii"); found && found != trampoline)
                return reinterpret_cast<int (*)(int, int)>(found)(val, size);
#endif
    return 0;
}
