// The upload's text, and what the compiler says about it.
#include "compile/diagnostics.h"
#include "source/definitions.h"
#include "source/includes.h"
#include "text.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace testat;
    std::string const text(reinterpret_cast<char const*>(data), size);
    for (auto const& all : {find_definitions(text), recover_definitions(text)})
        for (auto const& d : all)
            if (!(d.begin <= d.body && d.body <= d.end && d.end <= text.size() && d.line >= 1))
                std::abort();
    for (int line : {1, 2, 10})
        if (Extent const e = find_declaration(text, line); e.begin > e.end || e.end > text.size())
            std::abort();
    same_bodies(text, text);
    patch_definitions(text, text);
    included_headers(text, "/nowhere");
    parse_diagnostics(text, "exercise_03.cpp", "exercise_03.cpp");
    find_first_error(text, "exercise_03.cpp", "exercise_03.cpp");
    if (clean_text(text, 100).size() > 110)
        std::abort();
    return 0;
}
