// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Reads whatever descriptors are open, which might be request or answers: there is nothing to read.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <unistd.h>
#include <sys/mman.h>

bool tries()
{
    char byte;
    for (int fd = 0; fd < 1024; ++fd)
        if (pread(fd, &byte, 1, 0) == 1 || (fd > 2 && (read(fd, &byte, 1) == 1 || fcntl(fd, F_GETFD) >= 0)))
            return true;
    return false;
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
