#include "compile/diagnostics.h"

#include "text.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace testat {
namespace {
constexpr std::size_t most_bytes = 600;

std::string_view const severities[] = {"fatal error", "error", "warning", "note"};

/// Takes "123:" off the front.
std::optional<int> take_number(std::string_view& text)
{
    int number = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || number < 0 || end == text.data() + text.size() || *end != ':')
        return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()) + 1);
    return number;
}

std::optional<std::string_view> take_severity(std::string_view& text)
{
    for (auto severity : severities) {
        std::string const mark = std::string(severity) + ": ";
        if (text.substr(0, mark.size()) == mark) {
            text.remove_prefix(mark.size());
            return severity;
        }
    }
    return std::nullopt;
}

/// "file:line:column: severity: message", as g++ and clang++ write it.
std::optional<Diagnostic> parse_compiler_line(std::string_view line)
{
    std::size_t const colon = line.find(':');
    if (colon == 0 || colon == std::string_view::npos)
        return std::nullopt;
    Diagnostic d;
    d.file = std::string(line.substr(0, colon));
    std::string_view rest = line.substr(colon + 1);
    d.line = take_number(rest).value_or(0);
    d.column = take_number(rest).value_or(0);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    auto const severity = take_severity(rest);
    if (!severity)
        return std::nullopt;
    d.severity = std::string(*severity);
    d.message = clean_text(rest, most_bytes);
    return d;
}

bool is_linker(std::string const& program)
{
    auto const name = std::filesystem::path(program).filename().string();
    return name == "mold" || name == "ld" || name == "ld.mold" || name == "collect2" || name == "ld.lld";
}

bool is_program(std::string const& name)
{
    return is_linker(name) || name == "cc1plus" || name == "g++" || name == "clang" || name == "clang++";
}

/// The drivers' own line says only that the linker has failed.
bool only_repeats(Diagnostic const& d)
{
    return d.file == "collect2" || d.message.rfind("linker command failed", 0) == 0;
}

void name_file(Diagnostic& d, std::string const& source, std::string const& shown)
{
    if (d.file == source)
        d.file = shown;
    else if (is_program(d.file))
        d.file.clear();
    else
        d.file = clean_text(std::filesystem::path(d.file).filename().string(), 200);
}

int rank(Diagnostic const& d)
{
    return d.severity == "error" || d.severity == "fatal error" ? 0 : d.severity == "warning" ? 1 : 2;
}
}  // namespace

std::vector<Diagnostic> parse_diagnostics(std::string_view output, std::string const& source, std::string const& shown,
                                          std::size_t most)
{
    std::vector<Diagnostic> found;
    while (!output.empty()) {
        std::size_t const end = std::min(output.find('\n'), output.size());
        auto d = parse_compiler_line(output.substr(0, std::min<std::size_t>(end, 4096)));
        output.remove_prefix(std::min(end + 1, output.size()));
        if (!d || only_repeats(*d))
            continue;
        name_file(*d, source, shown);
        found.push_back(std::move(*d));
    }
    std::stable_sort(found.begin(), found.end(), [](auto const& a, auto const& b) { return rank(a) < rank(b); });
    if (found.size() > most)
        found.resize(most);
    return found;
}
}  // namespace testat
