// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Opens performance counters, to watch others: not allowed.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    unsigned attributes[32] = {1, 128};
    return syscall(SYS_perf_event_open, attributes, 0, -1, -1, 0) >= 0 || syscall(SYS_fanotify_init, 0, 0) >= 0 ||
           syscall(SYS_inotify_init1, 0) >= 0;
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
