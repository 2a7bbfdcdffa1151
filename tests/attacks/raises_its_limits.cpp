// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Raises its limits of time, memory and processes: they stay.
#ifndef WITHOUT_ATTACK
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    bool raised = false;
    for (auto resource : {RLIMIT_CPU, RLIMIT_AS, RLIMIT_NPROC, RLIMIT_FSIZE, RLIMIT_NOFILE}) {
        rlimit const none{RLIM_INFINITY, RLIM_INFINITY};
        raised = raised || setrlimit(resource, &none) == 0 || prlimit(0, resource, &none, nullptr) == 0 ||
                 prlimit(getppid(), resource, &none, nullptr) == 0;
    }
    return raised;
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
