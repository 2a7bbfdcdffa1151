// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Embeds the compiled solution with .incbin, to read it when it runs: there is no such file.
#ifndef WITHOUT_ATTACK
asm(".data\nstolen: .incbin \"@BUILD@/grader/references/all.so\"\n.text");
#endif
