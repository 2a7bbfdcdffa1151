// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Starts a shell, by each way there is to start a program: there is none, and no way.
#ifndef WITHOUT_ATTACK
#include <cstdlib>
#include <spawn.h>
#include <unistd.h>

bool tries()
{
    char name[] = "/bin/sh";
    char* arguments[] = {name, nullptr};
    pid_t shell;
    bool const started = std::system("touch /tmp/attacked") == 0 || posix_spawn(&shell, name, nullptr, nullptr, arguments, nullptr) == 0;
    execve(name, arguments, nullptr);
    execve("/usr/bin/g++", arguments, nullptr);
    return started;
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
