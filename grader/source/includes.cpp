#include "source/includes.h"

#include "source/lexer.h"

#include <fstream>
#include <sstream>

namespace testat {
namespace {
void collect(std::string_view text, std::filesystem::path const& include_root, std::set<std::string>& found)
{
    for (auto const& name : lex(text).includes) {
        bool const ours = name.rfind("cglib/", 0) == 0 && name.find("..") == std::string::npos;
        if (!ours || found.count(name) > 0)
            continue;
        std::ifstream in(include_root / name);
        if (!in)
            continue;
        found.insert(name);
        std::ostringstream header;
        header << in.rdbuf();
        collect(header.str(), include_root, found);
    }
}
}  // namespace

std::set<std::string> included_headers(std::string_view text, std::filesystem::path const& include_root)
{
    std::set<std::string> found;
    collect(text, include_root, found);
    return found;
}
}  // namespace testat
