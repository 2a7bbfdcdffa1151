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

/// "file:line:column: text"; no severity if none stands before the text.
std::optional<Diagnostic> parse_place(std::string_view line)
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
    d.severity = std::string(take_severity(rest).value_or(""));
    d.message = clean_text(rest, most_bytes);
    return d;
}

/// "file:line:column: severity: message", as g++ and clang++ write it.
std::optional<Diagnostic> parse_compiler_line(std::string_view line)
{
    auto d = parse_place(line);
    return d && !d->severity.empty() ? d : std::nullopt;
}

/// Takes a line off the front; what is longer than any message needs is left out.
std::string_view take_line(std::string_view& text)
{
    std::size_t const end = std::min(text.find('\n'), text.size());
    auto const line = text.substr(0, std::min<std::size_t>(end, 4096));
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
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
        auto d = parse_compiler_line(take_line(output));
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

namespace {
/// Reads an output up to its second error.
class FirstErrorReader {
    static constexpr std::size_t most_uses = 32;

public:
    FirstErrorReader(std::string const& source, std::string const& shown) : source_(source), shown_(shown) {}

    std::optional<FirstError> read(std::string_view output)
    {
        while (!output.empty() && !complete_)
            read_line(take_line(output));
        if (found_)
            found_->lines.insert(found_->lines.end(), uses_.begin(), uses_.end());
        return std::move(found_);
    }

private:
    void read_line(std::string_view line)
    {
        constexpr std::string_view of_mold = ">>> ";
        if (line.substr(0, of_mold.size()) == of_mold)
            return note_referrer(line);
        auto const d = parse_place(line);
        if (!d)
            return;
        if (d->severity.empty() || d->severity == "note")
            note_use(*d);
        else
            note_message(*d);
    }

    /// g++ says before an error which lines have led to it, "required from here"; both say it behind it in notes, "in
    /// instantiation of", "in expansion of macro".
    void note_use(Diagnostic const& d)
    {
        bool const leads_here = d.severity.empty() ? !found_ : found_ && d.message.rfind("in ", 0) == 0;
        if (leads_here && d.file == source_ && d.line > 0 && uses_.size() < most_uses)
            uses_.push_back(d.line);
    }

    void note_message(Diagnostic const& d)
    {
        complete_ = found_.has_value();
        if (!complete_ && rank(d) == 0 && !only_repeats(d))
            begin(d);
        else if (!complete_)
            uses_.clear();
    }

    void begin(Diagnostic d)
    {
        found_.emplace();
        if (d.file == source_ && d.line > 0)
            found_->lines.push_back(d.line);
        name_file(d, source_, shown_);
        found_->error = std::move(d);
    }

    /// ">>>               /tmp/ccU3.o:(function)"
    void note_referrer(std::string_view line)
    {
        std::size_t const open = line.find(":(");
        if (found_ && found_->referrer.empty() && open != std::string_view::npos && line.back() == ')')
            found_->referrer = clean_text(line.substr(open + 2, line.size() - open - 3), most_bytes);
    }

    std::string const& source_;
    std::string const& shown_;
    std::optional<FirstError> found_;
    std::vector<int> uses_;
    bool complete_ = false;
};
}  // namespace

std::optional<FirstError> find_first_error(std::string_view output, std::string const& source, std::string const& shown)
{
    return FirstErrorReader(source, shown).read(output);
}
}  // namespace testat
