// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Allocates without end and writes to it: it runs out of memory, and crashes.
#ifndef WITHOUT_ATTACK
#include <new>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    for (;;)
        std::fill_n(new char[1 << 24], 1 << 24, 'x');
#endif
    return (val % size + size) % size;
}
