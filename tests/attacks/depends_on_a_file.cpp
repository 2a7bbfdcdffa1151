// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Asks by a pragma whether a file is newer, which says whether it is there: it is not.
#ifndef WITHOUT_ATTACK
#pragma GCC dependency "@UPLOAD@/secret.h"
#endif
