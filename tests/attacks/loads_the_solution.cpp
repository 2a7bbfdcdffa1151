// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Loads the compiled solution and asks it: no library can be opened but the upload.
#ifndef WITHOUT_ATTACK
#include <dlfcn.h>

using Function = int (*)(int, int);
Function solution = nullptr;
bool tries()
{
    for (char const* library : {"@BUILD@/grader/references/all.so", "@BUILD@/grader/references/without_wrap_clamp.so"})
        if (void* const loaded = dlopen(library, RTLD_NOW))
            solution = Function(dlsym(loaded, "_ZN12ImageTexture11wrap_repeatEii"));
    return solution != nullptr;
}

bool const while_loading = tries();
bool succeeded()
{
    static bool const later = tries();
    return while_loading || later;
}
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
