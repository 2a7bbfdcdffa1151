// attack: {"at": "compile", "earns": [20, 20]}
// Thousands of long messages of a pragma: the file compiles, and what is shown of them is short.
#ifndef WITHOUT_ATTACK
#define A(x) x x x x x x x x x x
#define B(x) A(A(A(A(x))))
#define LINE "a message, a message, a message, a message, a message, a message, a message, a message, a message"
B(_Pragma("message(LINE LINE LINE LINE LINE LINE LINE LINE)"))
#endif
