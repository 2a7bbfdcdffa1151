// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Has the assembler read /etc/passwd, which would quote each line as a wrong instruction: there is no such file.
#ifndef WITHOUT_ATTACK
asm(".include \"/etc/passwd\"");
#endif
