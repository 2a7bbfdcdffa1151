// attack: {"at": "load", "earns": [0, 0], "says": {"*": "crashed"}, "policy": ["crashes"]}
// Ends the process while it is loaded: nothing has been answered.
#ifndef WITHOUT_ATTACK
#include <unistd.h>
[[gnu::constructor]] void end() { _exit(0); }
#endif
