// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Sets alarms that might go off in whoever comes after: there are none.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

bool tries()
{
    itimerval const soon{{0, 1000}, {0, 1000}};
    return setitimer(ITIMER_REAL, &soon, nullptr) == 0 || setitimer(ITIMER_PROF, &soon, nullptr) == 0 ||
           syscall(SYS_timerfd_create, 1, 0) >= 0;
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
