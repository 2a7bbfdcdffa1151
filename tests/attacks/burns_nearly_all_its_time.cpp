// attack: {"at": "run", "earns": [0, 20], "says": {"*": "any"}}
// Computes for nine seconds in each process, just below the limit of one: the limit of all of them holds.
#ifndef WITHOUT_ATTACK
#include <ctime>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    static bool burnt = false;
    while (!burnt)
        burnt = std::clock() > 9 * CLOCKS_PER_SEC;
#endif
    return (val % size + size) % size;
}
