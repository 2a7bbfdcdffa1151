// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Parentheses that are nested a million deep: the compiler's own stack does not hold that.
#ifndef WITHOUT_ATTACK
#define A(x) ((((((((((x))))))))))
#define B(x) A(A(A(A(A(A(A(A(A(A(x))))))))))
#define C(x) B(B(B(B(B(B(B(B(B(B(x))))))))))
#define D(x) C(C(C(C(C(C(C(C(C(C(x))))))))))
#define E(x) D(D(D(D(D(D(D(D(D(D(x))))))))))
int one = E(E(E(E(E(E(E(E(E(E(1))))))))));
#endif
