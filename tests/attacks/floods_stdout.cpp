// attack: {"at": "run", "earns": [20, 20]}
// Prints a gigabyte: the beginning is kept, and it goes on.
#ifndef WITHOUT_ATTACK
#include <unistd.h>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    static char const line[1 << 16] = {'a', 't', 't', 'a', 'c', 'k'};
    static bool const once = [] {
        for (int i = 0; i < (1 << 14); ++i)
            if (write(1, line, sizeof line) < 0 && write(2, line, sizeof line) < 0)
                break;
        return true;
    }();
    if (!once)
        return 0;
#endif
    return (val % size + size) % size;
}
