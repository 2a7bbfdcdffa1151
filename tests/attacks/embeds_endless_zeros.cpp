// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Embeds a device without end with .incbin, to read it when it runs: there is no such file.
#ifndef WITHOUT_ATTACK
asm(".data\nstolen: .incbin \"/dev/zero\"\n.text");
#endif
