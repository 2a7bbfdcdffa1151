// attack: {"at": "compile", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Brings the probe's table of slots and the calls that restrict and end a child: the probe has its own.
#ifndef WITHOUT_ATTACK
extern "C" void** testat_slot_table()
{
    static void* table[11];
    return table;
}
extern "C" long syscall(long, ...) noexcept { return 0; }
extern "C" int prctl(int, ...) noexcept { return 0; }
extern "C" int setrlimit(int, void const*) noexcept { return 0; }
extern "C" void* dlsym(void*, char const*) noexcept { return nullptr; }
extern "C" int close_range(unsigned, unsigned, int) noexcept { return 0; }
#endif

int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
