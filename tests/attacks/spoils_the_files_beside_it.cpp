// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Changes, removes, renames and relabels what lies beside the upload: out of reach.
#ifndef WITHOUT_ATTACK
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

bool tries()
{
    bool spoilt = false;
    for (char const* file : {"@UPLOAD@/points.csv", "@UPLOAD@/exercise_03.cpp", "@NEIGHBOUR@/exercise_03.cpp"})
        spoilt = spoilt || open(file, O_WRONLY | O_TRUNC) >= 0 || chmod(file, 0777) == 0 || truncate(file, 0) == 0 ||
                 utimensat(AT_FDCWD, file, nullptr, 0) == 0 || std::rename(file, "/tmp/attacked") == 0 ||
                 link(file, "/tmp/attacked") == 0 || unlink(file) == 0;
    return spoilt;
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
