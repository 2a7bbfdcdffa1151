#include "compile/mend.h"

#include "compile/diagnostics.h"
#include "compile/symbols.h"
#include "source/definitions.h"

#include <algorithm>

namespace testat {
namespace {
int count_lines(std::string_view text)
{
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

void blank(std::string& text, std::size_t begin, std::size_t end)
{
    std::replace_if(
        text.begin() + std::ptrdiff_t(begin), text.begin() + std::ptrdiff_t(end), [](char c) { return c != '\n'; },
        ' ');
}

/// Trampolines stand in for it wherever it is called.
void leave_out(std::string& text, Function function)
{
    for (auto const& d : recover_definitions(text))
        if (d.function == function)
            blank(text, d.begin, d.end);
}

struct Culprit {
    Function function;
    Diagnostic error;
};

Culprit blame(Function function, Diagnostic error, int line)
{
    error.line = line;
    return {function, std::move(error)};
}

/// Compilers complain of a missing brace where the next functions begin.
std::optional<Culprit> find_unclosed(FirstError const& first, std::vector<Definition> const& definitions)
{
    for (std::size_t i = 0; i + 1 < definitions.size(); ++i) {
        auto const& d = definitions[i];
        if (d.closed || first.lines.empty() || first.lines.front() < d.line)
            continue;
        Diagnostic error = first.error;
        error.message =
            "a '}' is missing before line " + std::to_string(definitions[i + 1].line) + ": " + first.error.message;
        return blame(d.function, error, d.line);
    }
    return std::nullopt;
}

std::optional<Culprit> find_by_line(FirstError const& first, std::vector<Definition> const& definitions,
                                    std::string_view text)
{
    for (int const line : first.lines)
        for (auto const& d : definitions)
            if (line >= d.line && line <= d.line + count_lines(text.substr(d.begin, d.end - d.begin)))
                return blame(d.function, first.error, line);
    return std::nullopt;
}

std::optional<Culprit> find_by_name(FirstError const& first, std::vector<Definition> const& definitions)
{
    for (Function f : every_function()) {
        if (demangle(std::string(info(f).symbol)) != first.referrer)
            continue;
        for (auto const& d : definitions)
            if (d.function == f)
                return blame(f, first.error, d.line);
    }
    return std::nullopt;
}

std::optional<Culprit> find_culprit(FirstError const& first, std::string_view text)
{
    auto const definitions = recover_definitions(text);
    if (auto unclosed = find_unclosed(first, definitions))
        return unclosed;
    if (auto found = find_by_line(first, definitions, text))
        return found;
    return find_by_name(first, definitions);
}

/// Declarations and #includes.
constexpr std::size_t most_left_out = 8;

void cut(Mended& mended, std::size_t begin, std::size_t end, Diagnostic const& error, int line)
{
    blank(mended.text, begin, end);
    mended.left_out.push_back(error);
    mended.left_out.back().line = line;
}

/// Leaves out the declaration that an error lies in, unless one of the eleven is part of it.
bool cut_declaration(FirstError const& first, Mended& mended)
{
    auto const definitions = recover_definitions(mended.text);
    constexpr std::size_t most_lines = 4;
    for (std::size_t i = 0; i < std::min(first.lines.size(), most_lines); ++i) {
        int const line = first.lines[i];
        Extent const found = find_declaration(mended.text, line);
        bool const overlaps = std::any_of(definitions.begin(), definitions.end(), [&](Definition const& d) {
            return d.begin < found.end && found.begin < d.end;
        });
        if (found.end == 0 || overlaps || mended.left_out.size() == most_left_out)
            continue;
        cut(mended, found.begin, found.end, first.error, line);
        return true;
    }
    return false;
}

/// What follows the # of the directive that begins at `at`; nothing if none does.
std::string_view directive(std::string_view text, std::size_t at)
{
    auto const skip_blanks = [&] { at = std::min(text.find_first_not_of(" \t", at), text.size()); };
    skip_blanks();
    if (text.substr(at, 1) == "#")
        at += 1;
    else if (text.substr(at, 2) == "%:")
        at += 2;
    else
        return {};
    skip_blanks();
    return text.substr(at);
}

bool starts_with(std::string_view text, std::string_view beginning)
{
    return text.substr(0, beginning.size()) == beginning;
}

/// Whether the directive that begins at `at` is #line, or # with a number, which means the same.
bool is_line_directive(std::string_view text, std::size_t at)
{
    auto const found = directive(text, at);
    return starts_with(found, "line") || (!found.empty() && found[0] >= '0' && found[0] <= '9');
}

/// Whether the line that the newline at `end` ends is continued by the next.
bool is_continued(std::string_view text, std::size_t end)
{
    auto const line = text.substr(0, end);
    std::size_t const last = line.find_last_not_of('\r');
    return last != std::string_view::npos && line[last] == '\\';
}

/// The end of the line that begins at `at`, with lines that continue it.
std::size_t end_of_line(std::string_view text, std::size_t at)
{
    std::size_t end = text.find('\n', at);
    while (end != std::string_view::npos && is_continued(text, end))
        end = text.find('\n', end + 1);
    return std::min(end, text.size());
}

/// Where a line begins, counted from 1.
std::size_t begin_of_line(std::string_view text, int line)
{
    std::size_t begin = 0;
    for (; line > 1 && begin < text.size(); --line)
        begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
    return begin;
}

/// Leaves out the #include that an error lies in: of a file that is not there. Its name may be that of a header that
/// everything needs, but for a letter, so such a header takes its place.
bool cut_include(FirstError const& first, std::string const& header, Mended& mended)
{
    if (first.lines.empty() || mended.left_out.size() == most_left_out)
        return false;
    std::size_t const begin = begin_of_line(mended.text, first.lines.front());
    if (!starts_with(directive(mended.text, begin), "include"))
        return false;
    cut(mended, begin, end_of_line(mended.text, begin), first.error, first.lines.front());
    if (!header.empty())
        mended.text.insert(begin, "#include \"" + header + "\" ");
    return true;
}
}  // namespace

std::string without_line_directives(std::string text)
{
    for (std::size_t at = 0; at < text.size();) {
        std::size_t const end = end_of_line(text, at);
        if (is_line_directive(text, at))
            blank(text, at, end);
        at = end + 1;
    }
    return text;
}

std::optional<Mended> mend(std::string const& text, Finished const& failed, MendedFile const& file,
                           CompileText const& compile)
{
    if (failed.timed_out || failed.signal != 0)
        return std::nullopt;
    Mended mended{without_line_directives(text), {}, {}};
    Finished last = mended.text == text ? failed : compile(mended.text);
    while (last.exit_code != 0) {
        if (last.timed_out || last.signal != 0)
            return std::nullopt;
        auto const first = find_first_error(last.output, file.source, file.shown);
        if (!first)
            return std::nullopt;
        if (auto const culprit = find_culprit(*first, mended.text)) {
            if (!mended.broken.emplace(culprit->function, culprit->error).second)
                return std::nullopt;
            leave_out(mended.text, culprit->function);
        } else if (!cut_include(*first, file.header, mended) && !cut_declaration(*first, mended)) {
            return std::nullopt;
        }
        last = compile(mended.text);
    }
    if (mended.broken.empty() && mended.left_out.empty())
        return std::nullopt;
    return mended;
}
}  // namespace testat
