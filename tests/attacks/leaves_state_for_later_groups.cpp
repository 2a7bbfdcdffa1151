// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Tells later children of the same upload something by all that might outlive it: nothing does.
#ifndef WITHOUT_ATTACK
#include <cstdlib>
#include <fcntl.h>
#include <sys/shm.h>
#include <unistd.h>

bool tries()
{
    bool const found = shmget(0x61747461, 1, 0) >= 0 || access("/tmp/attacked", F_OK) == 0 || getenv("ATTACKED") ||
                       fcntl(77, F_GETFD) >= 0 || nice(0) == 3;
    shmget(0x61747461, 1, IPC_CREAT | 0666);
    setenv("ATTACKED", "1", 1);
    dup2(0, 77);
    [[maybe_unused]] int const nicer = nice(3);
    return open("/tmp/attacked", O_CREAT | O_RDWR, 0666) >= 0 || found;
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
