// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Ends its only thread, whose destructors and handlers then run: what it has not answered is not answered.
#ifndef WITHOUT_ATTACK
#include <pthread.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    pthread_exit(nullptr);
#endif
    return (val % size + size) % size;
}
