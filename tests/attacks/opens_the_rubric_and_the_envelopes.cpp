// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Opens what says which points and pictures are expected: no file can be opened.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <unistd.h>

bool tries()
{
    return open("@REPOSITORY@/references/rubric.json", O_RDONLY) >= 0 ||
           open("@BUILD@/grader/envelopes/plane_after_b_repeat.envelope", O_RDONLY) >= 0 ||
           open("@BUILD@/grader/envelopes/plane_after_b_repeat.png", O_RDONLY) >= 0;
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
