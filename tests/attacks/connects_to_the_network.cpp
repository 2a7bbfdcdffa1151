// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Opens sockets of the internet, to talk to the host or the world: there is no network.
#ifndef WITHOUT_ATTACK
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

bool tries()
{
    sockaddr_in loopback = {};
    loopback.sin_family = AF_INET;
    loopback.sin_port = htons(22);
    loopback.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int const tcp = socket(AF_INET, SOCK_STREAM, 0);
    return socket(AF_INET, SOCK_DGRAM, 0) >= 0 || socket(AF_INET6, SOCK_STREAM, 0) >= 0 || tcp >= 0 ||
           connect(tcp, reinterpret_cast<sockaddr*>(&loopback), sizeof loopback) == 0;
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
