#include "report/printer.h"
#include "stress/stress_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat {
namespace {
constexpr Term heading{"Fehler in Einheiten der erlaubten Schranke (bis 1 ist richtig)",
                       "Error in units of the allowed bound (up to 1 is right)"};
constexpr Term function_term{"Funktion", "function"};
constexpr Term inputs{"Eingaben", "inputs"};
constexpr Term median{"Median", "median"};
constexpr Term most{"99,9 %", "99.9 %"};
constexpr Term worst{"größter", "largest"};
constexpr Term wrong_term{"falsch", "wrong"};
constexpr Term infinite_term{"unendlich", "infinite"};
constexpr Term crash{"Absturz", "crash"};
constexpr Term exception{"Ausnahme", "exception"};
constexpr Term timeout{"Zeitlimit", "time-out"};
constexpr Term left_out{"ausgelassen", "left out"};
constexpr Term undecided{"unentscheidbar", "undecided"};
constexpr Term counted{"Was sonst geschah", "What else happened"};
constexpr Term nothing{"  nichts: keine Abstürze, kein NaN, nichts Unendliches",
                       "  nothing: no crash, no NaN, nothing infinite"};
constexpr Term outside{"außerhalb des Vertrags", "outside the contract"};
constexpr Term not_written{"nicht geschrieben", "not written"};
constexpr Term worst_inputs{"Schlechteste Eingaben", "Worst inputs"};
constexpr Term input{"Eingabe ", "input   "};
constexpr Term measured{"Ergebnis", "measured"};
constexpr Term expected{"erwartet", "expected"};

class StressPrinter : Printer {
public:
    StressPrinter(Report const& document, Language language) : Printer(language), document_(document) {}

    std::string print()
    {
        line("{}, seed {}", text(document_.at("file")), document_.at("seed").dump());
        diagnostics();
        if (!document_.at("functions").empty()) {
            table();
            counts();
            worst_of_all();
        }
        return std::move(out_);
    }

private:
    void diagnostics()
    {
        if (document_.at("build").at("ok").get<bool>())
            return;
        line("{}", say(does_not_build));
        auto const& all = document_.at("build").at("diagnostics");
        for (std::size_t i = 0; i < std::min(shown_diagnostics, all.size()); ++i)
            line("  {}", diagnostic_line(all[i]));
    }

    /// Not finite: a wrong whole number, NaN or infinity.
    static std::string error(Report const& function, char const* key)
    {
        if (function.at("judged") == 0)
            return "-";
        return function.at(key).is_null() ? "∞" : fmt::format("{:.3g}", function.at(key).get<double>());
    }

    void table()
    {
        line("\n{}\n", say(heading));
        line("{:<36}{:>10}{:>10}{:>10}{:>10}{:>10}", say(function_term), say(inputs), say(median), say(most),
             say(worst), say(wrong_term));
        for (auto const& [name, f] : document_.at("functions").items()) {
            if (f.at("written").get<bool>())
                line("{:<36}{:>10}{:>10}{:>10}{:>10}{:>10}", name, f.at("in_contract").get<int>(), error(f, "median"),
                     error(f, "p999"), error(f, "max"), f.at("wrong").get<int>());
            else
                line("{:<36}{:>10}", name, say(not_written));
        }
    }

    std::string described(Report const& f) const
    {
        std::pair<char const*, Term> const keys[] = {
            {"nan", {"NaN", "NaN"}}, {"infinite", infinite_term}, {"crashed", crash},      {"exceptions", exception},
            {"timed_out", timeout},  {"not_answered", left_out},  {"undecided", undecided}};
        std::string all;
        for (auto const& [key, term] : keys)
            if (f.value(key, 0) > 0)
                all += fmt::format("{}{} {}", all.empty() ? "" : ", ", f.at(key).get<int>(), say(term));
        return all;
    }

    void counts()
    {
        line("\n{}", say(counted));
        bool any = false;
        for (auto const& [name, f] : document_.at("functions").items()) {
            std::string const inside = described(f);
            std::string const beyond = described(f.at("outside"));
            any = any || !inside.empty() || !beyond.empty();
            if (!inside.empty())
                line("  {}: {}", name, inside);
            if (!beyond.empty())
                line("  {}, {} ({}): {}", name, say(outside), f.at("outside").at("asked").get<int>(), beyond);
        }
        if (!any)
            line("{}", say(nothing));
    }

    void worst_of_all()
    {
        line("\n{}", say(worst_inputs));
        for (auto const& [name, f] : document_.at("functions").items()) {
            if (f.at("worst_input").is_null() || f.at("max") == 0)
                continue;
            line("  {} ({})", name, error(f, "max"));
            line("    {}  {}", say(input), text(f.at("worst_input")));
            line("    {}  {}", say(measured), text(f.at("measured")));
            line("    {}  {}", say(expected), text(f.at("expected")));
        }
    }

    Report const& document_;
};
}  // namespace

std::string stress_to_text(Report const& document, Language language)
{
    return StressPrinter(document, language).print();
}
}  // namespace testat
