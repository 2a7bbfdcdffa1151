// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Leaves keys in the kernel, where later processes of the same user find them: there are no keys.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    int const session = -3, user = -4;
    return syscall(SYS_add_key, "user", "attacked", "x", 1, user) > 0 || syscall(SYS_keyctl, 0, session, 1) > 0 ||
           syscall(SYS_request_key, "user", "attacked", nullptr, session) > 0;
}

bool const while_loading = tries();
bool succeeded()
{
    static bool const later = tries();
    return while_loading || later;
}
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
