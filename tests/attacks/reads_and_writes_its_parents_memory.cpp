// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Reads and writes memory of the fork server and takes its descriptors: not allowed.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

bool tries()
{
    char byte = 0;
    iovec const mine{&byte, 1};
    bool reached = false;
    for (pid_t process = 1; process < 64; ++process)
        if (process != getpid())
            reached = reached || process_vm_readv(process, &mine, 1, &mine, 1, 0) == 1 ||
                      process_vm_writev(process, &mine, 1, &mine, 1, 0) == 1 ||
                      syscall(SYS_pidfd_getfd, syscall(SYS_pidfd_open, process, 0), 4, 0) >= 0;
    return reached;
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
