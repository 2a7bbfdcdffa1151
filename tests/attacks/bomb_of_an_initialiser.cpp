// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// A gigabyte of data by one line: the library may not become that large.
#ifndef WITHOUT_ATTACK
int stone[1 << 28] = {1};
#endif
