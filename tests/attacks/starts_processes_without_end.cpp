// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Starts processes, and they start more: not one can be started.
#ifndef WITHOUT_ATTACK
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    bool started = false;
    for (long child = fork(); child >= 0; child = fork())
        started = true;
    long arguments[11] = {};
    return started || vfork() >= 0 || syscall(SYS_clone3, arguments, sizeof arguments) >= 0 ||
           syscall(SYS_clone, 0, 0, 0, 0, 0) >= 0;
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
