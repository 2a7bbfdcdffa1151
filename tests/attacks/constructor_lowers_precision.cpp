// attack: {"at": "load", "earns": [20, 20]}
// Has the old floating-point unit compute with 24 bits from the moment it is loaded: set back.
#ifndef WITHOUT_ATTACK
[[gnu::constructor]] void lower()
{
    unsigned short control = 0x007f;
    asm volatile("fldcw %0" : : "m"(control));
}
#endif
