// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Ends the process without handlers: what it has not answered is not answered.
#ifndef WITHOUT_ATTACK
#include <cstdlib>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::quick_exit(0);
#endif
    return (val % size + size) % size;
}
