// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Changes rubric, reference libraries and the library that it is loaded from: out of reach, or read-only.
#ifndef WITHOUT_ATTACK
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

bool tries()
{
    Dl_info mine = {};
    dladdr(reinterpret_cast<void*>(&tries), &mine);
    bool spoilt = false;
    for (char const* file : {"@REPOSITORY@/references/rubric.json", "@BUILD@/grader/references/all.so", mine.dli_fname})
        spoilt = spoilt || open(file, O_WRONLY) >= 0 || truncate(file, 0) == 0 || unlink(file) == 0;
    return spoilt;
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
