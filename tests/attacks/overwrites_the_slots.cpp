// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Has all trampolines jump to its own functions, or one to another: in its own process only.
#ifndef WITHOUT_ATTACK
#include <dlfcn.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    static void** const slots = reinterpret_cast<void** (*)()>(dlsym(RTLD_DEFAULT, "testat_slot_table"))();
    slots[2] = slots[1];
    return wrap_repeat(val, size);
#endif
    return 0;
}
