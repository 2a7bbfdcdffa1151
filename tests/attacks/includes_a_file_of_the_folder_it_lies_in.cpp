// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Includes what lies beside the upload; only the upload itself is there, so it does not compile and tells nothing.
#ifndef WITHOUT_ATTACK
#include "@UPLOAD@/secret.h"
#endif
