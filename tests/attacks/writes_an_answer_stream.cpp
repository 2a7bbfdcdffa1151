// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Writes a whole stream of right answers to whatever descriptor might lead to the judge: none does.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <unistd.h>

bool tries()
{
    unsigned stream[4096] = {0x74737431};
    bool written = false;
    for (int fd = 3; fd < 1024; ++fd)
        written = written || pwrite(fd, stream, sizeof stream, 0) > 0 || write(fd, stream, sizeof stream) > 0;
    return written;
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
