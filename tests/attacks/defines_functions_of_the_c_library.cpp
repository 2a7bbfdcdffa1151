// attack: {"at": "compile", "earns": [20, 20]}
// Brings memcpy, floor, log2f, malloc and operator new of its own: everybody else has those of the system.
#ifndef WITHOUT_ATTACK
extern "C" void* memcpy(void* to, void const*, std::size_t) noexcept { return to; }
extern "C" double floor(double) noexcept { return 7; }
extern "C" float floorf(float) noexcept { return 7; }
extern "C" float log2f(float) noexcept { return 7; }
extern "C" void* malloc(std::size_t) noexcept { return nullptr; }
void* operator new(std::size_t) { throw 7; }
void operator delete(void*) noexcept {}
#endif
