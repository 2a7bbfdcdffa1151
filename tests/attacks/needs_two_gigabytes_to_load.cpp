// attack: {"at": "compile", "earns": [0, 0], "says": {"*": "crashed"}, "policy": ["crashes"]}
// Variables of nearly two gigabytes that cost no space in the file: it builds, and cannot be loaded.
#ifndef WITHOUT_ATTACK
char stones[0x7d000000];
#endif
