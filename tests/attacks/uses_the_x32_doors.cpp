// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Makes system calls by the numbers of the x32 interface, which a filter might forget: ended by the kernel.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    constexpr long x32 = 0x40000000;
    return syscall(x32 + SYS_fork) >= 0 || syscall(x32 + SYS_socket, 1, 1, 0) >= 0 || syscall(x32 + SYS_open, "/", 0) >= 0;
}

bool succeeded()
{
    static bool const once = tries();
    return once;
}
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
