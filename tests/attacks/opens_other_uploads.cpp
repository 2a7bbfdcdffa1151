// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Opens its own text, its folder and what somebody else has handed in: none of it is there.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <unistd.h>

bool tries()
{
    return open("@NEIGHBOUR@/exercise_03.cpp", O_RDONLY) >= 0 || open("@UPLOAD@/exercise_03.cpp", O_RDONLY) >= 0 ||
           open("@UPLOAD@", O_RDONLY | O_DIRECTORY) >= 0 || open("exercise_03.cpp", O_RDONLY) >= 0;
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
