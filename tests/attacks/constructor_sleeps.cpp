// attack: {"at": "load", "earns": [0, 0], "says": {"*": "timed_out"}}
// Waits for nothing while it is loaded: stopped by the clock, once for all.
#ifndef WITHOUT_ATTACK
#include <unistd.h>
[[gnu::constructor]] void wait() { sleep(100000); }
#endif
