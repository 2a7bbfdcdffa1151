// attack: {"at": "load", "earns": [20, 20]}
// Rounds upwards from the moment it is loaded: the mode is set back, and no function is spoilt.
#ifndef WITHOUT_ATTACK
#include <cfenv>
[[gnu::constructor]] void round_upwards() { std::fesetround(FE_UPWARD); }
#endif
