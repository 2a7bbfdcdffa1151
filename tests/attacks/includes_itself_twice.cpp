// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Includes itself twice, and so on: the compiler is stopped by depth, time or memory.
#ifndef WITHOUT_ATTACK
#include __FILE__
#include __FILE__
#endif
