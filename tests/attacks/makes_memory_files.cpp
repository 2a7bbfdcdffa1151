// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Makes files in memory, which no limit of memory counts: there are none.
#ifndef WITHOUT_ATTACK
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    return memfd_create("attacked", 0) >= 0 || syscall(SYS_memfd_secret, 0) >= 0;
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
