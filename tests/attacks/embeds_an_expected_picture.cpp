// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Embeds an expected picture with .incbin, to read it when it runs: there is no such file.
#ifndef WITHOUT_ATTACK
asm(".data\nstolen: .incbin \"@BUILD@/grader/envelopes/plane_after_c.envelope\"\n.text");
#endif
