#pragma once
#include "report/report.h"
#include "report/text.h"

#include <fmt/format.h>

#include <string>

namespace testat {
/// Words of ours in both languages.
struct Term {
    char const* de;
    char const* en;
};

constexpr char const* say(Term term, Language language)
{
    return language == Language::de ? term.de : term.en;
}

/// "exercise_03.cpp:12: error: ..."
inline std::string diagnostic_line(Report const& d)
{
    std::string place = d.at("file").get<std::string>();
    if (int const number = d.at("line").get<int>(); number > 0)
        place += fmt::format(":{}", number);
    return fmt::format("{}{}{}: {}", place, place.empty() ? "" : ": ", d.at("severity").get<std::string>(),
                       d.at("message").get<std::string>());
}

/// What texts for people are printed with, line by line.
class Printer {
public:
    explicit Printer(Language language) : language_(language) {}

protected:
    char const* say(Term term) const { return testat::say(term, language_); }
    static std::string text(Report const& value) { return value.get<std::string>(); }
    std::string phrase(Report const& value) const { return text(value.at(language_ == Language::de ? "de" : "en")); }

    template <typename... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments)
    {
        out_ += fmt::format(format, std::forward<Arguments>(arguments)...) + "\n";
    }

    static constexpr std::size_t shown_diagnostics = 3;
    static constexpr Term does_not_build{"Die Datei lässt sich nicht übersetzen oder binden:",
                                         "The file does not compile or link:"};
    std::string out_;

private:
    Language language_;
};
}  // namespace testat
