#include "compile/symbols.h"

#include "text.h"

#include <cxxabi.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

namespace testat {
namespace {
constexpr std::size_t nm_memory = std::size_t(1) << 30;
constexpr double nm_cpu_s = 10;

struct Symbol {
    char type;  ///< as nm prints it
    std::string name;
};

struct Symbols {
    std::vector<Symbol> list;
    bool cut = false;  ///< there are more
};

/// By somebody outside: no file that it reads does that to nm before its time is up.
bool was_killed(Finished const& nm)
{
    int const signal = nm.signal != 0 ? nm.signal : nm.exit_code - 128;
    return (signal == SIGKILL || signal == SIGTERM) && !nm.timed_out && nm.cpu_s < nm_cpu_s;
}

/// What nm cannot read has no symbols: it was a stranger's text that told the linker what to write.
Symbols read_symbols(std::filesystem::path const& library, Cage& cage)
{
    Caged nm{{{"nm", "-D", "--defined-only", library.string()}, "/", {}, nm_cpu_s, 30, nm_memory, 1}};
    nm.sees = compiler_directories();
    nm.sees.push_back(library);
    Finished finished = cage.run(nm);
    if (was_killed(finished))
        finished = cage.run(nm);
    if (was_killed(finished))
        throw std::runtime_error("somebody has killed nm, which reads the symbols of what was built");
    Symbols symbols;
    symbols.cut = finished.output.size() >= most_output;
    std::istringstream lines(finished.exit_code == 0 ? finished.output : "");
    std::string address;
    Symbol symbol;
    while (lines >> address >> symbol.type >> symbol.name)
        symbols.list.push_back(symbol);
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
    int status = 0;
    std::unique_ptr<char, void (*)(void*)> text(abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status),
                                                std::free);
    return status == 0 ? text.get() : name;
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

/// The declaration of a function with this name among the symbols; empty if there is none. A stranger's names can keep
/// a demangler busy for ever, so that is done in the cage.
std::string find_declaration(std::string_view function, std::vector<Symbol> const& symbols, Cage& cage)
{
    constexpr std::size_t longest_name = 300;
    constexpr std::size_t most_names = 20;
    Caged filter{{{"c++filt", "--"}, "/", {}, 1, 5, nm_memory, 1}};
    std::size_t const options = filter.command.argv.size();
    for (auto const& symbol : symbols)
        if (symbol.name.size() <= longest_name && symbol.name.find(function) != std::string::npos &&
            filter.command.argv.size() < options + most_names)
            filter.command.argv.push_back(symbol.name);
    if (filter.command.argv.size() == options)
        return "";
    filter.sees = compiler_directories();
    std::istringstream lines(cage.run(filter).output);
    for (std::string line; std::getline(lines, line);)
        if (declares(line, function))
            return one_line(line, 400);
    return "";
}

std::string explain_missing(Function f, std::vector<Symbol> const& symbols, Cage& cage)
{
    std::string const wanted = as_written(demangle(std::string(info(f).symbol)));
    std::string const found = find_declaration(info(f).name, symbols, cage);
    if (found.empty())
        return wanted + " is missing";
    return wanted + " is missing; the file defines " + as_written(found) + " instead (the declaration was changed)";
}
}  // namespace

SymbolReport check_symbols(std::filesystem::path const& library, std::string const& shown, Installation const& where,
                           Cage& cage)
{
    constexpr std::size_t most_duplicates = 20;
    auto const symbols = read_symbols(library, cage);
    auto const taken = framework_symbols(where);
    SymbolReport report;
    if (symbols.cut)
        report.duplicates.push_back(error(shown, "the file defines too many symbols, more than 1 MB of names"));
    for (auto const& symbol : symbols.list) {
        for (Function f : every_function())
            if (symbol.name == info(f).symbol && (is_strong(symbol) || symbol.type == 'W'))
                report.defined = report.defined.with(f);
        if (report.duplicates.size() < most_duplicates && is_strong(symbol) &&
            (taken.count(symbol.name) > 0 || symbol.name == "main"))
            report.duplicates.push_back(error(shown, "multiple definition: " + as_written(demangle(symbol.name)) +
                                                         " is part of the framework already"));
    }
    for (Function f : every_function())
        if (!report.defined.has(f))
            report.missing[f] = error(shown, explain_missing(f, symbols.list, cage));
    return report;
}
}  // namespace testat
