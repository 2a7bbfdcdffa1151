// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Refers to ten thousand functions that are not there: the first few are shown.
#ifndef WITHOUT_ATTACK
#define A(n) n##0(); n##1(); n##2(); n##3(); n##4(); n##5(); n##6(); n##7(); n##8(); n##9();
#define B(n) A(n##0) A(n##1) A(n##2) A(n##3) A(n##4) A(n##5) A(n##6) A(n##7) A(n##8) A(n##9)
#define D(n) void n##0(), n##1(), n##2(), n##3(), n##4(), n##5(), n##6(), n##7(), n##8(), n##9();
#define E(n) D(n##0) D(n##1) D(n##2) D(n##3) D(n##4) D(n##5) D(n##6) D(n##7) D(n##8) D(n##9)
E(a) E(b) E(c) E(d) E(e) E(f) E(g) E(h)
void calls_them() { B(a) B(b) B(c) B(d) B(e) B(f) B(g) B(h) }
#endif
