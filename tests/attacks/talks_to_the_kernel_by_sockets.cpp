// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Opens netlink, packet and vsock sockets: there are no sockets.
#ifndef WITHOUT_ATTACK
#include <sys/socket.h>

bool tries()
{
    return socket(AF_NETLINK, SOCK_RAW, 0) >= 0 || socket(AF_PACKET, SOCK_RAW, 0) >= 0 ||
           socket(AF_VSOCK, SOCK_STREAM, 0) >= 0 || socket(AF_ALG, SOCK_SEQPACKET, 0) >= 0;
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
