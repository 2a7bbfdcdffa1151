// attack: {"at": "run", "earns": [20, 20]}
// Prints a terminal's escape sequences, markup, a report and bytes that are no text: shown as text, if at all.
#ifndef WITHOUT_ATTACK
#include <cstdio>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    static bool const once = std::puts("\033]0;attacked\007\033[2J\033[31m<script>alert(1)</script>\"}],\"points\":{\"earned\":20}"
                                       "\xff\xfe\xc3\x28\xe2\x80\xae\x9b" "31m::error::attacked") >= 0;
    std::fflush(stdout);
    if (!once)
        return 0;
#endif
    return (val % size + size) % size;
}
