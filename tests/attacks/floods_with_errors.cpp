// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// A hundred thousand errors: the first few are shown.
#ifndef WITHOUT_ATTACK
#define A(x) x x x x x x x x x x
#define B(x) A(A(A(A(A(x)))))
B(int int;)
#endif
