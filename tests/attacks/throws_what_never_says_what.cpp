// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "timed_out"}}
// Throws an exception whose what() runs for ever: stopped by its time limit.
#ifndef WITHOUT_ATTACK
#include <exception>
struct Endless : std::exception {
    char const* what() const noexcept override
    {
        for (int volatile i = 0;; i = i + 1) {
        }
    }
};
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    throw Endless();
#endif
    return (val % size + size) % size;
}
