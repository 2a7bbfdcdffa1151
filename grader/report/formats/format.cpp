#include "report/formats/format.h"

#include "report/reading.h"

#include <algorithm>

namespace testat {
namespace {
constexpr Term no_build{"Die Datei lässt sich nicht übersetzen oder binden; diese Funktion für sich:",
                        "The file does not compile or link; this function by itself:"};
constexpr Term input{"Eingabe", "input"};
constexpr Term measured{"Ergebnis", "measured"};
constexpr Term expected{"erwartet", "expected"};
constexpr Term not_right{"Alle Prüfungen bestanden, aber nicht alle Bilder, an denen die Funktion beteiligt ist",
                         "All checks passed, but not all pictures that the function takes part in"};

/// Empty where a report has no words.
std::string in_language(Report const& phrase, Language language)
{
    if (!phrase.is_object())
        return "";
    return phrase.at(language == Language::de ? "de" : "en").get<std::string>();
}

/// "plane_after_c, goboard_after_c"
std::string wrong_pictures(Report const& report, std::string const& function)
{
    std::string names;
    for (auto const& picture : report.at("pictures")) {
        auto const& functions = picture.at("functions");
        bool const takes_part = std::find(functions.begin(), functions.end(), function) != functions.end();
        if (takes_part && picture.at("score") < 1)
            names += (names.empty() ? "" : ", ") + picture.at("name").get<std::string>();
    }
    return names;
}
}  // namespace

std::vector<Format> const& formats()
{
    static std::vector<Format> const all{
        {"csv", "report.csv", true, to_csv},       {"gradescope", "results.json", false, to_gradescope},
        {"html", "report.html", false, to_html},   {"junit", "junit.xml", true, to_junit},
        {"sarif", "report.sarif", true, to_sarif},
    };
    return all;
}

std::string explain_check(Report const& check, Language language)
{
    std::string text = in_language(check.at("hint"), language);
    if (!check.at("worst_input").is_object())
        return text;
    auto const& worst = check.at("worst_input");
    for (auto const& [key, term] :
         {std::pair("input", input), std::pair("measured", measured), std::pair("expected", expected)})
        if (worst.contains(key) && worst.at(key).is_string())
            text += fmt::format("\n{}: {}", say(term, language), worst.at(key).get<std::string>());
    return text;
}

std::string explain_function(Report const& report, std::string const& name, Language language)
{
    Report const& function = report.at("functions").at(name);
    if (Reading const reading(report); !reading.builds())
        return fmt::format("{} {}", say(no_build, language), say(reading.word_for(name), language));
    std::string text;
    if (function.contains("mistake"))
        text = in_language(function.at("mistake"), language);
    for (auto const& check : function.at("checks"))
        if (!check.at("passed").get<bool>())
            return text + (text.empty() ? "" : "\n") + check.at("name").get<std::string>() + ": " +
                   explain_check(check, language);
    return function.at("picture") < 1 ? fmt::format("{}: {}", say(not_right, language), wrong_pictures(report, name))
                                      : text;
}
}  // namespace testat
