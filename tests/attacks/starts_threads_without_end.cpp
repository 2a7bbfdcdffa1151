// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Starts threads without end, as memory for them is shared: not one can be started.
#ifndef WITHOUT_ATTACK
#include <pthread.h>
#include <unistd.h>

void* waits(void*)
{
    for (;;)
        pause();
}
bool tries()
{
    bool started = false;
    for (pthread_t thread; pthread_create(&thread, nullptr, waits, nullptr) == 0;)
        started = true;
    return started;
}

bool succeeded()
{
    static bool const once = tries();
    return once;
}
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
