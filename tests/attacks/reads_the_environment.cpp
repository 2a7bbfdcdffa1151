// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Looks for a secret of whoever started the grader in the environment: it is not passed on.
#ifndef WITHOUT_ATTACK
#include <cstdlib>
#include <cstring>
#include <unistd.h>

bool tries()
{
    for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable)
        if (std::strstr(*variable, "TESTAT_SECRET") != nullptr || std::strstr(*variable, "HOME=/root") != nullptr)
            return true;
    return std::getenv("TESTAT_SECRET") != nullptr;
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
