// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "timed_out"}}
// Remembers a frame of one call and jumps there from another: whatever comes of it, it is not right.
#ifndef WITHOUT_ATTACK
#include <csetjmp>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    static jmp_buf gone;
    static bool const first = setjmp(gone) == 0;
    if (!first || val != 0)
        longjmp(gone, 1);
#endif
    return (val % size + size) % size;
}
