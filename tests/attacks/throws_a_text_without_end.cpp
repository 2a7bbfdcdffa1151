// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Throws an exception whose text has no end, up to memory that is not there: it has crashed.
#ifndef WITHOUT_ATTACK
#include <exception>
#include <sys/mman.h>
struct Endless : std::exception {
    char const* what() const noexcept override
    {
        auto* page = static_cast<char*>(mmap(nullptr, 8192, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        std::fill_n(page, 4096, 'x');
        munmap(page + 4096, 4096);
        return page;
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
