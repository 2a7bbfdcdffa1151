#include "compile/symbols.h"

#include "text.h"

#include <cxxabi.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

namespace testat {
namespace {
constexpr std::size_t nm_memory = std::size_t(1) << 30;

struct Symbol {
    char type;  ///< as nm prints it
    std::string name;
};

/// What nm cannot read has no symbols: it was a stranger's text that told the linker what to write.
std::vector<Symbol> read_symbols(std::filesystem::path const& library, Cage& cage)
{
    Caged nm{{{"nm", "-D", "--defined-only", library.string()}, "/", {}, 10, 30, nm_memory, 1}};
    nm.sees = compiler_directories();
    nm.sees.push_back(library);
    Finished const finished = cage.run(nm);
    std::vector<Symbol> symbols;
    std::istringstream lines(finished.exit_code == 0 ? finished.output : "");
    std::string address;
    Symbol symbol;
    while (lines >> address >> symbol.type >> symbol.name)
        symbols.push_back(symbol);
    return symbols;
}

bool is_strong(Symbol const& symbol)
{
    return std::string("TDBR").find(symbol.type) != std::string::npos;
}

std::set<std::string> framework_symbols(Installation const& where)
{
    std::ifstream in(where.libraries / "framework_symbols.txt");
    std::set<std::string> names;
    for (std::string name; std::getline(in, name);)
        names.insert(name);
    if (names.empty())
        throw std::runtime_error((where.libraries / "framework_symbols.txt").string() + " is missing or empty");
    return names;
}

}  // namespace

std::string demangle(std::string const& name)
{
    constexpr std::size_t longest = 300;
    if (name.size() > longest)
        return clean_text(name, 100);
    int status = 0;
    std::unique_ptr<char, void (*)(void*)> text(abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status),
                                                std::free);
    return clean_text(status == 0 ? text.get() : name.c_str(), 400);
}

namespace {
bool declares(std::string const& declaration, std::string_view function)
{
    std::size_t const at = declaration.find(std::string(function) + "(");
    return at == 0 || (at != std::string::npos && declaration[at - 1] == ':');
}

Diagnostic error(std::string const& file, std::string const& message)
{
    return {file, 0, 0, "error", message};
}

/// With the framework's names for vectors and matrices.
std::string as_written(std::string declaration)
{
    auto const replace = [&](std::string const& long_name, std::string const& name) {
        for (std::size_t at = 0; (at = declaration.find(long_name, at)) != std::string::npos;)
            declaration.replace(at, long_name.size(), name);
    };
    for (std::string const n : {"2", "3", "4"}) {
        replace("glm::vec<" + n + ", float, (glm::qualifier)0>", "glm::vec" + n);
        replace("glm::mat<" + n + ", " + n + ", float, (glm::qualifier)0>", "glm::mat" + n);
    }
    return declaration;
}

std::string explain_missing(Function f, std::vector<Symbol> const& symbols)
{
    std::string const wanted = as_written(demangle(std::string(info(f).symbol)));
    for (auto const& symbol : symbols)
        if (std::string const found = demangle(symbol.name); declares(found, info(f).name))
            return wanted + " is missing; the file defines " + as_written(found) +
                   " instead (the declaration was changed)";
    return wanted + " is missing";
}
}  // namespace

SymbolReport check_symbols(std::filesystem::path const& library, std::string const& shown, Installation const& where,
                           Cage& cage)
{
    auto const symbols = read_symbols(library, cage);
    auto const taken = framework_symbols(where);
    SymbolReport report;
    for (auto const& symbol : symbols) {
        for (Function f : every_function())
            if (symbol.name == info(f).symbol && (is_strong(symbol) || symbol.type == 'W'))
                report.defined = report.defined.with(f);
        if (is_strong(symbol) && (taken.count(symbol.name) > 0 || symbol.name == "main"))
            report.duplicates.push_back(error(shown, "multiple definition: " + as_written(demangle(symbol.name)) +
                                                         " is part of the framework already"));
    }
    for (Function f : every_function())
        if (!report.defined.has(f))
            report.missing[f] = error(shown, explain_missing(f, symbols));
    return report;
}
}  // namespace testat
