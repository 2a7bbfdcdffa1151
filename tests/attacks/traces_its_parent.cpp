// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Attaches to the fork server as a debugger, or has itself traced: not allowed.
#ifndef WITHOUT_ATTACK
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    bool traced = false;
    for (pid_t process = 1; process < 64; ++process)
        traced = traced || ptrace(PTRACE_ATTACH, process, 0, 0) == 0 || ptrace(PTRACE_SEIZE, process, 0, 0) == 0 ||
                 syscall(SYS_kcmp, process, getpid(), 1, 0, 0) >= 0;
    return traced || ptrace(PTRACE_TRACEME, 0, 0, 0) == 0;
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
