// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Has the kernel open files by io_uring, past any filter of system calls: there is none.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    char parameters[120] = {};
    return syscall(SYS_io_uring_setup, 4, parameters) >= 0 || syscall(SYS_io_setup, 4, parameters) == 0;
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
