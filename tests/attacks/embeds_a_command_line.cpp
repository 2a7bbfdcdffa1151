// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Embeds the command line of the first process with .incbin, to read it when it runs: there is no such file.
#ifndef WITHOUT_ATTACK
asm(".data\nstolen: .incbin \"/proc/1/cmdline\"\n.text");
#endif
