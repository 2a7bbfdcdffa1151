// Build tool: copies an exercise file with the body of one function replaced by abort(), for the reference library
// that stands around an upload's version of that function: blank_function FUNCTION IN OUT
#include "source/definitions.h"

#include <cstdio>
#include <fstream>
#include <sstream>

int main(int argc, char** argv)
{
    if (argc != 4)
        return std::fputs("usage: blank_function FUNCTION IN OUT\n", stderr), 2;
    auto const function = testat::find_function(argv[1]);
    std::ifstream in(argv[2]);
    std::stringstream text;
    text << in.rdbuf();
    if (!function || !in || testat::find_definitions(text.str()).size() != testat::function_count)
        return std::fprintf(stderr, "blank_function: %s does not define all functions\n", argv[2]), 1;
    std::ofstream out(argv[3]);
    out << "#include <cstdlib>\n" << testat::replace_body(text.str(), *function, "{ std::abort(); }");
    return out.flush() ? 0 : 1;
}
