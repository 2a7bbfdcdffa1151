// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Throws a text with escape sequences, markup and a second report, of a megabyte: shown as text, cut short.
#ifndef WITHOUT_ATTACK
#include <stdexcept>
#include <string>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    throw std::runtime_error("\033]0;attacked\007\033[31m<script>\"}\n::error::\xff\xe2\x80\xae" + std::string(1 << 20, '\x9b'));
#endif
    return (val % size + size) % size;
}
