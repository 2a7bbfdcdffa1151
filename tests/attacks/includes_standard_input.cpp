// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Includes what the compiler's standard input gives, and would wait for it: there is nothing.
#ifndef WITHOUT_ATTACK
#include "/dev/stdin"
#include "/proc/self/fd/0"
#endif
