// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Embeds the rubric with .incbin, to read it when it runs: there is no such file.
#ifndef WITHOUT_ATTACK
asm(".data\nstolen: .incbin \"@REPOSITORY@/references/rubric.json\"\n.text");
#endif
