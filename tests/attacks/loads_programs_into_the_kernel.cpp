// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Loads a program of bpf into the kernel: not allowed.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    unsigned map[32] = {2, 4, 4, 1}, program[32] = {1, 0};
    return syscall(SYS_bpf, 0, map, sizeof map) >= 0 || syscall(SYS_bpf, 5, program, sizeof program) >= 0;
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
