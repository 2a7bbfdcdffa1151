// attack: {"at": "compile", "earns": [20, 20]}
// Asks linker and loader for another library and for search paths by sections of its own: not read.
#ifndef WITHOUT_ATTACK
asm(".section .deplibs,\"MS\",@llvm_dependent_libraries,1\n.asciz \"@UPLOAD@/secret.h\"\n.text");
#endif
