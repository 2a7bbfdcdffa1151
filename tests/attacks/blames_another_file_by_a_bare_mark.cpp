// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// The same with the preprocessor's own marks: only the upload is quoted.
#ifndef WITHOUT_ATTACK
# 1 "/etc/passwd" 1 3
this is no declaration;
#endif
