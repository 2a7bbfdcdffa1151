// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Asks the assembler for two gigabytes of ones: no file may become that large.
#ifndef WITHOUT_ATTACK
asm(".data\n.fill 0x7fffffff, 1, 1\n.text");
#endif
