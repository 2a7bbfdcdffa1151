// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Empties, shrinks and moves the memory that it shares with the server: that loses only its own answers.
#ifndef WITHOUT_ATTACK
#include <sys/mman.h>
#include <utility>
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
    static unsigned* const board = find_board();
    static bool taken = false;
    if (board != nullptr && !std::exchange(taken, true)) {
        std::signal(SIGSEGV, SIG_DFL);
        madvise(board, 1 << 20, MADV_REMOVE);
        mremap(board, 1 << 20, 4096, 0);
        munmap(board, 1 << 20);
    }
#endif
    return (val % size + size) % size;
}
