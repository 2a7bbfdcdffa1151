// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Changes how the kernel lays out memory and makes all of it executable: stays as it is.
#ifndef WITHOUT_ATTACK
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

bool tries()
{
    return personality(ADDR_NO_RANDOMIZE) != -1 || personality(READ_IMPLIES_EXEC) != -1 ||
           prctl(PR_SET_NAME, "testat", 0, 0, 0) == 0 || prctl(PR_SET_PDEATHSIG, 0, 0, 0, 0) == 0;
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
