// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Asks about processes, users and the machine what concerns nobody: not answered.
#ifndef WITHOUT_ATTACK
#include <sys/syscall.h>
#include <sys/sysinfo.h>
#include <unistd.h>

bool tries()
{
    struct sysinfo about = {};
    char text[64];
    return syscall(SYS_syslog, 3, text, sizeof text) > 0 || sysinfo(&about) == 0 || getsid(0) > 0;
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
