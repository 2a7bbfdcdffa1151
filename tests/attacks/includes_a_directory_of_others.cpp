// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Includes the folder of the upload: a folder is no file, and this one is not there.
#ifndef WITHOUT_ATTACK
#include "@UPLOAD@"
#endif
