// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Says that its error is in another file, for the message to quote that file: only the upload is quoted.
#ifndef WITHOUT_ATTACK
#line 1 "@UPLOAD@/secret.h"
this is no declaration;
#endif
