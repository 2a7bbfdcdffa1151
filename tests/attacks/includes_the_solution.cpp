// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Includes the solution instead of writing one: there is no such file.
#ifndef WITHOUT_ATTACK
#include "@REPOSITORY@/references/exercise_03.cpp"
#endif
