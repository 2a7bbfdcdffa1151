// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Finds the blackboard, writes that all is done, with silly numbers and texts, and ends: no answer, no point.
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
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    if (unsigned* const board = find_board()) {
        std::fill_n(board + 1, 64, 0xffffffffu);
        board[0] = 5;
        _exit(0);
    }
    return 0;
#endif
    return (val % size + size) % size;
}
