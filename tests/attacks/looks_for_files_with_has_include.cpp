// attack: {"at": "compile", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Asks which files there are, of the solution, rubric, envelopes, other uploads, the system; none of them is.
#ifndef WITHOUT_ATTACK
#if __has_include("@REPOSITORY@/references/exercise_03.cpp") || __has_include("@REPOSITORY@/references/rubric.json")
#define FOUND
#elif __has_include("@BUILD@/grader/references/all.so") || __has_include("@NEIGHBOUR@/exercise_03.cpp")
#define FOUND
#elif __has_include("@BUILD@/grader/envelopes/plane_after_c.png") || __has_include("/etc/passwd")
#define FOUND
#elif __has_include("/proc/self/environ") || __has_include("../../../../etc/passwd")
#define FOUND
#endif
#ifdef FOUND
bool succeeded() { return true; }
#else
bool succeeded() { return false; }
#endif
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
