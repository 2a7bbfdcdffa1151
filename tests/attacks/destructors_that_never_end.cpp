// attack: {"at": "run", "earns": [20, 20]}
// Global and thread-local objects whose destructors run for ever or kill: no destructor is run.
#ifndef WITHOUT_ATTACK
#include <csignal>
struct Endless {
    ~Endless()
    {
        kill(-1, SIGKILL);
        for (int volatile i = 0;; i = i + 1) {
        }
    }
};
Endless global;
thread_local Endless local;
Endless* const used = &local;
[[gnu::destructor]] void unload() { global.~Endless(); }
#endif
