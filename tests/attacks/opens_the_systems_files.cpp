// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Opens files and folders of the system: none can be opened.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <unistd.h>
#include <dirent.h>

bool tries()
{
    bool opened = false;
    for (char const* file : {"/", "/etc", "/etc/passwd", "/etc/hostname", "/home", "/root", "/tmp", "/sys", "/dev", "."})
        opened = opened || open(file, O_RDONLY) >= 0 || opendir(file) != nullptr || access(file, F_OK) == 0;
    return opened;
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
