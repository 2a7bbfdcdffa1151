// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Shared memory of which one page stays mapped stays in memory, and no limit counts it: there is none to be had.
#ifndef WITHOUT_ATTACK
#include <sys/mman.h>

static bool succeeded()
{
    constexpr std::size_t size = 64 << 20;
    constexpr std::size_t page = 4096;
    for (int i = 0; i < 4; ++i) {
        void* const block =
            mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
        if (block == MAP_FAILED)
            return false;
        munmap(static_cast<char*>(block) + page, size - page);
    }
    return true;
}
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    static bool const once = succeeded();
    if (once)
        return (val % size + size) % size;
#endif
    return 0 * val;
}
