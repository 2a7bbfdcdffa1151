// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// A few lines that are a billion words: the compiler is stopped by time or memory.
#ifndef WITHOUT_ATTACK
#define A(x) x x x x x x x x x x
#define B(x) A(A(A(x)))
int sum = 0 B(B(B(+1)));
#endif
