#include "probe/slots.h"

#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <system_error>

extern "C" testat::Code* testat_slot_table();

namespace testat {
Code get_slot(Function function)
{
    return testat_slot_table()[static_cast<std::uint32_t>(function)];
}

void set_slot(Function function, Code code)
{
    testat_slot_table()[static_cast<std::uint32_t>(function)] = code;
}

void* load_library(std::string const& path)
{
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        throw std::runtime_error(dlerror());
    return library;
}

namespace {
/// The library's own definition. A look-up by handle also searches the libraries it needs, so the trampoline of the
/// same name can come back; that one would jump to itself for ever.
Code own_definition(void* library, Function function)
{
    std::string const symbol(info(function).symbol);
    Code const found = dlsym(library, symbol.c_str());
    return found == dlsym(RTLD_DEFAULT, symbol.c_str()) ? nullptr : found;
}

/// In bytes, as the library's symbol table says it.
std::size_t size_of(Code code)
{
    Dl_info where{};
    void* symbol = nullptr;
    if (dladdr1(code, &where, &symbol, RTLD_DL_SYMENT) == 0 || symbol == nullptr)
        throw std::runtime_error("a function of the reference has no symbol");
    return static_cast<ElfW(Sym) const*>(symbol)->st_size;
}

void protect(unsigned char* begin, unsigned char* end, int protection)
{
    auto const page = static_cast<std::size_t>(getpagesize());
    std::size_t const before = reinterpret_cast<std::uintptr_t>(begin) % page;
    if (mprotect(begin - before, static_cast<std::size_t>(end - begin) + before, protection) != 0)
        throw std::system_error(errno, std::generic_category(), "the reference's code cannot be changed");
}

void fill_with_traps(unsigned char* code, std::size_t size)
{
    constexpr int trap = 0xcc;  // x86: int3
    protect(code, code + size, PROT_READ | PROT_WRITE);
    std::memset(code, trap, size);
    protect(code, code + size, PROT_READ | PROT_EXEC);
}
}  // namespace

void remove_bodies(void* library, FunctionSet functions)
{
    for (Function f : every_function())
        if (functions.has(f))
            if (Code const code = own_definition(library, f))
                fill_with_traps(static_cast<unsigned char*>(code), size_of(code));
}

void fill_slots(void* library, FunctionSet functions)
{
    for (Function f : every_function())
        if (functions.has(f))
            if (Code const code = own_definition(library, f))
                set_slot(f, code);
}
}  // namespace testat
