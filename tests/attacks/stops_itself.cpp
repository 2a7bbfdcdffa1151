// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "timed_out"}}
// Stops its own process, so that it never ends: stopped by the clock.
#ifndef WITHOUT_ATTACK
#include <csignal>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::raise(SIGSTOP);
#endif
    return (val % size + size) % size;
}
