// attack: {"at": "compile", "earns": [20, 20], "builds": false}
// More names than the list of symbols holds, so that what comes last in it would not be looked at.
#ifndef WITHOUT_ATTACK
asm(R"(
    .data
    .macro symbol
    .globl a_name_that_is_as_long_as_it_can_be_without_being_suspicious_\@
a_name_that_is_as_long_as_it_can_be_without_being_suspicious_\@: .byte 0
    .endm
    .rept 20000
    symbol
    .endr
    .text
)");
#endif
