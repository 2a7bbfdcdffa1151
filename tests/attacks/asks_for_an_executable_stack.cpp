// attack: {"at": "compile", "earns": [20, 20]}
// Asks the loader for a stack that can be executed: whether it gets one or not, that helps nobody.
#ifndef WITHOUT_ATTACK
asm(".section .note.GNU-stack,\"x\",@progbits\n.text");
#endif
