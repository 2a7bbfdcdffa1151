// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Raises its priority, lowers that of others, and binds itself to one processor: stays as it is.
#ifndef WITHOUT_ATTACK
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    sched_param const highest{1};
    unsigned long const first = 1;
    return setpriority(PRIO_PROCESS, 0, -20) == 0 || setpriority(PRIO_PROCESS, getppid(), 19) == 0 ||
           sched_setscheduler(0, SCHED_FIFO, &highest) == 0 || syscall(SYS_sched_setaffinity, 0, sizeof first, &first) == 0 ||
           syscall(SYS_ioprio_set, 1, 0, 0x2000) == 0 || mlockall(MCL_CURRENT) == 0;
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
