// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Changes its root and its folder, the old way out of a cage: it stays.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    return chroot("/") == 0 || chdir("..") == 0 || fchdir(3) == 0 || syscall(SYS_name_to_handle_at, AT_FDCWD, "/", 0, 0, 0) == 0 ||
           syscall(SYS_open_by_handle_at, AT_FDCWD, nullptr, 0) >= 0;
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
