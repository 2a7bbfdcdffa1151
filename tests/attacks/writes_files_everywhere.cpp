// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Writes files where programs usually may: no file can be made, inside or outside.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

bool tries()
{
    bool written = false;
    for (char const* file : {"attacked", "/attacked", "/tmp/attacked", "/var/tmp/attacked", "/dev/shm/attacked",
                             "/run/attacked", "@UPLOAD@/attacked", "@UPLOAD@/../temporary/attacked", "out/attacked"})
        written = written || open(file, O_WRONLY | O_CREAT, 0666) >= 0 || mkdirat(AT_FDCWD, file, 0777) == 0 ||
                  symlink("/etc/passwd", file) == 0 || mkfifo(file, 0666) == 0;
    return written || open("/tmp", O_TMPFILE | O_RDWR, 0600) >= 0;
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
