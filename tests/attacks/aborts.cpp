// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Aborts: it has crashed.
#ifndef WITHOUT_ATTACK
#include <cstdlib>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::abort();
#endif
    return (val % size + size) % size;
}
