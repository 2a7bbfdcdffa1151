// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Writes a report with all points where the real one will lie, or is made: out of reach.
#ifndef WITHOUT_ATTACK
#include <fcntl.h>
#include <unistd.h>

bool tries()
{
    char const report[] = "{\"status\": \"graded\", \"points\": {\"earned\": 20, \"max\": 20}}";
    bool written = false;
    for (char const* file : {"report.json", "../report.json", "@UPLOAD@/../out/report.json", "@UPLOAD@/report.json"}) {
        int const fd = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0666);
        written = written || write(fd, report, sizeof report - 1) > 0;
    }
    return written;
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
