// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Makes memory that can be written and executed: there is none once the file is loaded.
#ifndef WITHOUT_ATTACK
#include <sys/mman.h>

bool tries()
{
    void* const page = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return mprotect(page, 4096, PROT_READ | PROT_EXEC) == 0 ||
           mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
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
