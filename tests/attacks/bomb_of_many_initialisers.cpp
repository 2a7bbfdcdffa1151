// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// An array with a billion values that are all written out: stopped by time or memory.
#ifndef WITHOUT_ATTACK
#define A(...) __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__
#define B(...) A(A(A(__VA_ARGS__)))
double stones[] = {B(B(B(1)))};
#endif
