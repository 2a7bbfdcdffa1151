#include "report/reading.h"

#include <algorithm>
#include <tuple>

namespace testat {
namespace {
constexpr Term broken{"kompiliert nicht", "does not compile"};
constexpr Term not_judged{"nicht bewertet", "not judged"};
constexpr Term differs{"weicht ab wegen", "differs because of"};
constexpr Term isolated{"{} Pixel falsch, auch wenn alles andere stimmt", "{} pixel{} wrong even if all else is right"};
constexpr Term not_made{"konnte nicht erzeugt werden", "could not be made"};
constexpr Term unwritten{"Noch nicht geschrieben.", "Not written yet."};
constexpr Term file_is_broken{"Die Datei lässt sich nicht übersetzen oder binden:",
                              "The file does not compile or link:"};
constexpr Term pictures_are_wrong{
    "Alle Prüfungen bestanden, aber nicht alle Bilder, an denen die Funktion beteiligt ist.",
    "All checks passed, but not all pictures that the function takes part in."};

Term verdict_term(std::string const& verdict)
{
    constexpr std::pair<char const*, Term> terms[] = {
        {"correct", {"richtig", "correct"}}, {"partial", {"teilweise", "partial"}},
        {"wrong", {"falsch", "wrong"}},      {"missing", {"fehlt", "missing"}},
        {"crashed", {"Absturz", "crashed"}}, {"timed_out", {"Zeitlimit", "timed out"}},
    };
    auto const found =
        std::find_if(std::begin(terms), std::end(terms), [&](auto const& term) { return verdict == term.first; });
    return found == std::end(terms) ? Term{"?", "?"} : found->second;
}

Phrase phrase_of(Report const& words)
{
    return {words.at("de").get<std::string>(), words.at("en").get<std::string>()};
}

Phrase both(Term term)
{
    return {term.de, term.en};
}
}  // namespace

bool Reading::is_public_only() const
{
    for (auto const& function : report_.at("functions"))
        for (auto const& check : function.at("checks"))
            if (check.at("visibility") == "hidden")
                return false;
    return true;
}

bool Reading::applies(char const* policy) const
{
    auto const& applied = report_.at("policy").at("applied");
    return std::find(applied.begin(), applied.end(), policy) != applied.end();
}

Report const* Reading::graded(std::string const& name) const
{
    auto const& functions = has_unofficial() ? report_.at("unofficial").at("functions") : report_.at("functions");
    auto const found = functions.find(name);
    return found == functions.end() ? nullptr : &*found;
}

double Reading::earned_by(std::string const& name) const
{
    if (auto const& official = report_.at("functions").at(name); official.contains("override"))
        return official.at("earned").get<double>();
    auto const* const function = graded(name);
    return function == nullptr ? 0 : function->at("earned").get<double>();
}

double Reading::earned_in(Report const& task) const
{
    double sum = 0;
    for (auto const& [name, function] : report_.at("functions").items())
        sum += function.at("task") == task.at("id") ? earned_by(name) : 0;
    return sum;
}

double Reading::lost_by(std::string const& name) const
{
    return std::max(0.0, report_.at("functions").at(name).at("max").get<double>() - earned_by(name));
}

bool Reading::is_missing(std::string const& name) const
{
    return report_.at("functions").at(name).at("verdict") == "missing";
}

Term Reading::word_for(std::string const& name) const
{
    if (auto const* const function = graded(name))
        return was_run() || is_missing(name) ? verdict_term(function->at("verdict").get<std::string>()) : not_judged;
    return is_missing(name) ? verdict_term("missing") : broken;
}

/// Whether nobody has written a function yet, that compiles, whose points depend on the picture.
bool Reading::is_unwritten(Report const& picture) const
{
    auto const& functions = picture.at("functions");
    return std::all_of(functions.begin(), functions.end(), [&](Report const& name) {
        auto const* const function = graded(name.get<std::string>());
        return function == nullptr || function->at("verdict") == "missing";
    });
}

std::string Reading::finding_alone(Report const& picture, Language language) const
{
    if (picture.at("score") == 1 || is_unwritten(picture))
        return "";
    if (picture.at("isolated_file").is_null())
        return say(not_made, language);
    auto const outside = picture.at("outside").get<std::size_t>();
    return fmt::format(fmt::runtime(say(isolated, language)), outside, outside == 1 ? "" : "s");
}

std::string Reading::finding(Report const& picture, Language language) const
{
    std::string alone = finding_alone(picture, language);
    if (!picture.contains("explained_by"))
        return alone;
    return fmt::format("{} {}{}{}", say(differs, language), join(picture.at("explained_by")), alone.empty() ? "" : "; ",
                       alone);
}

FirstFix Reading::fix_of_build() const
{
    FirstFix fix;
    fix.what = both(file_is_broken);
    fix.lost = report_.at("points").at("max").get<double>();
    std::string message;
    auto const& all = report_.at("build").at("diagnostics");
    auto const& places = has_unofficial() ? report_.at("unofficial").at("broken") : Report::object();
    if (!places.empty()) {
        fix.function = places.begin().key();
        fix.line = places.begin()->at("line").get<int>();
        message = places.begin()->at("message").get<std::string>();
    } else if (!all.empty()) {
        message = diagnostic_line(all[0]);
    }
    fix.hint = {message, message};
    return fix;
}

/// Whatever a tutor has given the function itself.
bool Reading::costs_everything(std::string const& name) const
{
    auto const* const function = graded(name);
    return function != nullptr && function->at("verdict") == "crashed" && applies("crashes");
}

/// A crash that costs everything goes before all; then what has been written before what has not, what a check has
/// found before what only pictures show, and of these what costs most.
std::optional<std::string> Reading::function_to_fix() const
{
    auto const rank = [&](std::string const& name) {
        bool const has_hint = first_hint(report_.at("functions").at(name)) != nullptr;
        return std::tuple(costs_everything(name), !is_missing(name), has_hint, lost_by(name));
    };
    std::optional<std::string> chosen;
    for (auto const& [name, function] : report_.at("functions").items())
        if ((lost_by(name) > 0 || costs_everything(name)) && (!chosen || rank(name) > rank(*chosen)))
            chosen = name;
    return chosen;
}

FirstFix Reading::fix_of(std::string const& name) const
{
    Report const& function = report_.at("functions").at(name);
    FirstFix fix;
    fix.function = name;
    fix.line = function.at("source").is_null() ? 0 : function.at("source").at("line").get<int>();
    fix.lost = lost_by(name);
    Report const* const check = first_hint(function);
    Phrase const hint = check == nullptr ? Phrase{} : phrase_of(check->at("hint"));
    if (is_missing(name)) {
        fix.what = both(unwritten);
    } else if (function.contains("mistake")) {
        fix.what = phrase_of(function.at("mistake"));
        fix.hint = hint;
    } else {
        fix.what = check == nullptr ? both(pictures_are_wrong) : hint;
    }
    return fix;
}

std::vector<std::string> Reading::by_hand() const
{
    std::vector<std::string> lines;
    auto const add = [&](std::string const& what, Report const& place) {
        if (!place.contains("override"))
            return;
        auto const& given = place.at("override");
        lines.push_back(fmt::format("{}: {:.2f} -> {:.2f}, {} ({}, {})", what, given.at("points_before").get<double>(),
                                    place.at("earned").get<double>(), given.at("reason").get<std::string>(),
                                    given.at("who").get<std::string>(), given.at("when").get<std::string>()));
    };
    add("total", report_.at("points"));
    for (auto const& [name, function] : report_.at("functions").items())
        add(name, function);
    return lines;
}

std::optional<FirstFix> Reading::first_fix() const
{
    if (!builds())
        return fix_of_build();
    auto const name = function_to_fix();
    return name ? std::optional(fix_of(*name)) : std::nullopt;
}

std::string join(Report const& names)
{
    std::string all;
    for (auto const& name : names)
        all += (all.empty() ? "" : ", ") + name.get<std::string>();
    return all;
}

Report const* first_hint(Report const& function)
{
    for (auto const& check : function.at("checks"))
        if (!check.at("hint").is_null())
            return &check;
    return nullptr;
}
}  // namespace testat
