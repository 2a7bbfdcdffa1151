// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Includes a device without end: there is no such file.
#ifndef WITHOUT_ATTACK
#include "/dev/zero"
#endif
