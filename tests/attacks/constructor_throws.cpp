// attack: {"at": "load", "earns": [0, 0], "says": {"*": "crashed"}, "policy": ["crashes"]}
// Throws while it is loaded: it crashes.
#ifndef WITHOUT_ATTACK
int const thrown = []() -> int { throw 7; }();
#endif
