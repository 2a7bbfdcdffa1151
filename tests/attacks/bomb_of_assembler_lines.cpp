// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Repeats one line of assembler a hundred million times: stopped by time, memory or size.
#ifndef WITHOUT_ATTACK
asm(".rept 100000000\nnop\n.endr");
#endif
