// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Has one trampoline jump to where another does: in its own process only, and that is no right answer.
#ifndef WITHOUT_ATTACK
#include <dlfcn.h>
#endif

int ImageTexture::wrap_repeat(int, int)
{
#ifndef WITHOUT_ATTACK
    static void** const slots = reinterpret_cast<void** (*)()>(dlsym(RTLD_DEFAULT, "testat_slot_table"))();
    slots[2] = slots[1];
#endif
    return 0;
}
