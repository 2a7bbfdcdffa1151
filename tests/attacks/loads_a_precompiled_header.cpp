// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Has the compiler load a precompiled header of its choice, which would be data it trusts: not by a pragma.
#ifndef WITHOUT_ATTACK
#pragma GCC pch_preprocess "@UPLOAD@/secret.h"
#endif
