// attack: {"at": "load", "earns": [20, 20]}
// Has small numbers flushed to zero and traps unmasked from the moment it is loaded: set back.
#ifndef WITHOUT_ATTACK
#include <xmmintrin.h>
[[gnu::constructor]] void flush() { _mm_setcsr((_mm_getcsr() | 0x8040) & ~0x1000u); }
#endif
