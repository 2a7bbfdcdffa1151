// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Includes what somebody else has handed in, by a path with ../: there is no such file.
#ifndef WITHOUT_ATTACK
#include "@UPLOAD@/../neighbour/exercise_03.cpp"
#endif
