// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Includes /etc/passwd, whose lines an error message would quote: there is no such file.
#ifndef WITHOUT_ATTACK
#include "/etc/passwd"
#endif
