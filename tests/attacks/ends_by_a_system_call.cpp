// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Ends the process past the C library: what it has not answered is not answered.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <unistd.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    syscall(SYS_exit_group, 0);
#endif
    return (val % size + size) % size;
}
