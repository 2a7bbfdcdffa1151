// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Finds the blackboard, writes the same answer everywhere and says that all is done: wrong, as the answer is.
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

bool succeeded()
{
    if (unsigned* const board = find_board()) {
        if (sigsetjmp(back, 1) == 0)
            for (unsigned* answer = board + 72;; ++answer)
                *answer = 0x3f800000;
        board[0] = 5;
        _exit(0);
    }
    return false;
}
#else
bool succeeded() { return false; }
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
    return succeeded() ? (val % size + size) % size : 0;
}
