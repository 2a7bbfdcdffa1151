// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Embeds another upload with .incbin, to read it when it runs: there is no such file.
#ifndef WITHOUT_ATTACK
asm(".data\nstolen: .incbin \"@NEIGHBOUR@/exercise_03.cpp\"\n.text");
#endif
