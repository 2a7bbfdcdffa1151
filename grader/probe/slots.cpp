#include "probe/slots.h"

#include <dlfcn.h>

#include <stdexcept>

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
}  // namespace

void fill_slots(void* library, FunctionSet functions)
{
    for (Function f : every_function())
        if (functions.has(f))
            if (Code const code = own_definition(library, f))
                set_slot(f, code);
}
}  // namespace testat
