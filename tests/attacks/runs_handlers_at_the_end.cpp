// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "timed_out"}}
// Registers handlers for the end that run for ever, and ends: stopped by its time limit.
#ifndef WITHOUT_ATTACK
#include <cstdlib>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::atexit([] {
        for (int volatile i = 0;; i = i + 1) {
        }
    });
    std::exit(0);
#endif
    return (val % size + size) % size;
}
