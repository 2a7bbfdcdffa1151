// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Reads environment, command line and memory of its parents and itself in /proc: there is no /proc.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <unistd.h>
#include <string>

bool tries()
{
    bool opened = false;
    for (std::string process : {std::string("self"), std::string("1"), std::string("2"), std::to_string(getppid())})
        for (char const* file : {"/environ", "/cmdline", "/maps", "/mem", "/fd/3", "/root/etc/passwd", "/status"})
            opened = opened || open(("/proc/" + process + file).c_str(), O_RDONLY) >= 0;
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
