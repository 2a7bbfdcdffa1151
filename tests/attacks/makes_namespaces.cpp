// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Makes itself a root of its own with mounts of its own: no namespace in this one.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    return unshare(CLONE_NEWUSER) == 0 || unshare(CLONE_NEWNS) == 0 || unshare(CLONE_NEWPID | CLONE_NEWNET) == 0 ||
           syscall(SYS_clone, CLONE_NEWUSER | 17, 0, 0, 0, 0) >= 0 || setns(0, 0) == 0 ||
           mount("none", "/tmp", "tmpfs", 0, nullptr) == 0 || umount2("/", MNT_DETACH) == 0 ||
           syscall(SYS_pivot_root, "/", "/") == 0 || syscall(SYS_open_tree, AT_FDCWD, "/", 1) >= 0;
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
