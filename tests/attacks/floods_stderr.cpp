// attack: {"at": "run", "earns": [20, 20]}
// Prints to stderr whenever it is called: the beginning is kept, and it goes on.
#ifndef WITHOUT_ATTACK
#include <cstdio>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::fprintf(stderr, "wrap_repeat(%d, %d) is asked\n", val, size);
#endif
    return (val % size + size) % size;
}
