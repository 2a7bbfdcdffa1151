// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Embeds a file as later C does: no directive of this compiler, and no such file.
#ifndef WITHOUT_ATTACK
char const stolen[] = {
#embed "/etc/passwd"
};
#endif
