// attack: {"at": "run", "earns": [19, 20], "says": {"*": "any"}, "policy": ["crashes"]}
// Leaves the direction flag set and the old floating-point stack full: that spoils its own process at most.
int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    asm volatile("fld1; fld1; fld1; fld1; fld1; fld1; fld1; fld1; std");
#endif
    return (val % size + size) % size;
}
