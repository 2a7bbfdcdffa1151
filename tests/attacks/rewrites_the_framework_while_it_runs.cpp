// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Makes the framework's code writable, to put its own in its place: not once the file is loaded.
#ifndef WITHOUT_ATTACK
#include <cstdint>
#include <sys/mman.h>

bool tries()
{
    auto const method = &ImageTexture::get_texel;
    auto const code = *reinterpret_cast<std::uintptr_t const*>(&method);
    return mprotect(reinterpret_cast<void*>(code & ~0xfffull), 8192, PROT_READ | PROT_WRITE | PROT_EXEC) == 0;
}

bool succeeded()
{
    static bool const once = tries();
    return once;
}
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
