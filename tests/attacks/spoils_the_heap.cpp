// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Overwrites the heap's own records, and frees what is not on it: it crashes.
#ifndef WITHOUT_ATTACK
#include <cstdlib>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::fill_n(new char[8], 4096, 'x');
    std::free(reinterpret_cast<void*>(&val));
#endif
    return (val % size + size) % size;
}
