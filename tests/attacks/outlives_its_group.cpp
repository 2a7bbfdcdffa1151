// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Leaves a process behind that goes on when its group has ended: none can be started.
#ifndef WITHOUT_ATTACK
#include <sys/prctl.h>
#include <unistd.h>

bool tries()
{
    pid_t const child = fork();
    if (child == 0) {
        setsid();
        prctl(PR_SET_PDEATHSIG, 0);
        if (fork() == 0)
            sleep(1000);
        _exit(0);
    }
    return child > 0;
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
