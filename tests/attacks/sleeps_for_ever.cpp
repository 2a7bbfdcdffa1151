// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "timed_out"}}
// Waits for nothing, which takes no time of the processor: stopped by the clock.
#ifndef WITHOUT_ATTACK
#include <unistd.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    for (;;)
        sleep(1000);
#endif
    return (val % size + size) % size;
}
