// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Becomes root, or somebody else, or regains rights: it stays who it is.
#ifndef WITHOUT_ATTACK
#include <grp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    return setuid(0) == 0 || setresuid(0, 0, 0) == 0 || setgid(0) == 0 || setgroups(0, nullptr) == 0 ||
           prctl(PR_CAPBSET_READ, 21, 0, 0, 0) == 1 || prctl(PR_SET_DUMPABLE, 1, 0, 0, 0) == 0;
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
