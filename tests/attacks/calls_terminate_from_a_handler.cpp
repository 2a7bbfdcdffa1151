// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Throws while an exception is thrown, and has a handler that ends with success: it has crashed.
#ifndef WITHOUT_ATTACK
#include <cstdlib>
#include <exception>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::set_terminate([] { std::_Exit(0); });
    []() noexcept { throw 7; }();
#endif
    return (val % size + size) % size;
}
