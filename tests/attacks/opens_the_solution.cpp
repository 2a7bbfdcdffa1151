// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Opens the solution, as text and compiled, in every way there is: no file can be opened.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <unistd.h>
#include <sys/syscall.h>

bool tries()
{
    bool opened = false;
    for (char const* file : {"@REPOSITORY@/references/exercise_03.cpp", "@BUILD@/grader/references/all.so",
                             "@BUILD@/grader/references/without_wrap_clamp.so", "@BUILD@/grader/testat"}) {
        long how[3] = {O_RDONLY, 0, 0};
        opened = opened || open(file, O_RDONLY) >= 0 || syscall(SYS_openat2, AT_FDCWD, file, how, sizeof how) >= 0 ||
                 syscall(SYS_open, file, O_RDONLY) >= 0;
    }
    return opened;
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
