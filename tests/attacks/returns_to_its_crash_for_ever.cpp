// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "timed_out"}}
// Crashes, with a handler that returns to the crash, so that it goes on for ever: stopped by its time limit.
#ifndef WITHOUT_ATTACK
#include <csignal>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::signal(SIGSEGV, [](int) {});
    struct sigaction again = {};
    again.sa_handler = [](int) {};
    sigaction(SIGSEGV, &again, nullptr);
    return *static_cast<int volatile*>(nullptr);
#endif
    return (val % size + size) % size;
}
