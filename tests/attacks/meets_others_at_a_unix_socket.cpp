// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Waits for other processes at sockets in a file and without one (abstract): there are no sockets.
#ifndef WITHOUT_ATTACK
#include <cstddef>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>

bool waits_at(char const* name, std::size_t size)
{
    sockaddr_un place = {};
    place.sun_family = AF_UNIX;
    std::memcpy(place.sun_path, name, size);
    int const fd = socket(AF_UNIX, SOCK_STREAM, 0);
    return bind(fd, reinterpret_cast<sockaddr*>(&place), socklen_t(offsetof(sockaddr_un, sun_path) + size)) == 0;
}
bool tries()
{
    int pair[2];
    return waits_at("/tmp/attacked.socket", 20) || waits_at("\0attacked", 9) || socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0;
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
