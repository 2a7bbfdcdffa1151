/* Every function of the sheet as a jump through a slot. This library is the first in the global scope, so every call
   to one of the eleven, from the framework, from a reference or between an upload's own functions, lands here and
   goes where the slot points (System V x86-64; no register and no flag is touched on the way). */
        .bss
        .balign 8
local_slots:
        .zero   88

        .text
/* Where the slots are. A function, because an executable would take a copy of exported data. */
        .globl  testat_slot_table
        .type   testat_slot_table, @function
testat_slot_table:
        lea     local_slots(%rip), %rax
        ret
        .size   testat_slot_table, . - testat_slot_table

#define FUNCTION(index, name, symbol, task) \
        .globl symbol; .type symbol, @function; .balign 16; \
symbol: jmp *(local_slots + 8 * index)(%rip); \
        .size symbol, . - symbol;
#include "functions.def"

        .section .note.GNU-stack, "", @progbits
