// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "timed_out"}}
// Blocks and ignores all signals, then computes for ever: stopped by its time limit.
#ifndef WITHOUT_ATTACK
#include <csignal>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, nullptr);
    for (int signal = 1; signal < 65; ++signal)
        std::signal(signal, SIG_IGN);
    for (int volatile i = 0;; i = i + 1) {
    }
#endif
    return (val % size + size) % size;
}
