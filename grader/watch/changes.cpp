#include "watch/changes.h"

#include "report/printer.h"
#include "report/wrap.h"

#include <fmt/format.h>

#include <cmath>

namespace testat {
namespace {
constexpr Term of{"von", "of"};
constexpr Term points{"Punkten", "points"};
constexpr Term unchanged{"unverändert", "unchanged"};
constexpr Term input{"Eingabe", "input"};
constexpr Term measured{"Ergebnis", "measured"};
constexpr Term hint{"Hinweis", "hint"};
constexpr Term cause{"Ursache", "cause"};
constexpr Term all_right{"  alle Prüfungen bestanden", "  all checks passed"};

double earned(Report const& record)
{
    return record.at("earned").get<double>();
}

class ChangesPrinter : Printer {
public:
    ChangesPrinter(Report const* before, Report const& after, Language language)
        : Printer(language), before_(before), after_(after)
    {
    }

    std::string print()
    {
        headline();
        functions();
        if (!after_.at("build").at("ok").get<bool>())
            first_message();
        else
            first_mistake();
        return std::move(out_);
    }

private:
    void headline()
    {
        auto const& now = after_.at("points");
        line("{}: {:.2f} {} {:.2f} {}{}", text(after_.at("submission").at("file")), earned(now), say(of),
             now.at("max").get<double>(), say(points), difference(earned(now)));
    }

    std::string difference(double now) const
    {
        if (before_ == nullptr)
            return "";
        double const gained = now - earned(before_->at("points"));
        return std::abs(gained) < 1e-9 ? fmt::format(" ({})", say(unchanged)) : fmt::format(" ({:+.2f})", gained);
    }

    void functions()
    {
        if (before_ == nullptr)
            return;
        for (auto const& [name, function] : after_.at("functions").items())
            if (before_->at("functions").contains(name)) {
                double const was = earned(before_->at("functions").at(name)), is = earned(function);
                if (std::abs(is - was) > 1e-9)
                    line("  {:<40}{:>5.2f} -> {:>5.2f}  {:+.2f}", name, was, is, is - was);
            }
    }

    void first_message()
    {
        line("{}", say(does_not_build));
        auto const& all = after_.at("build").at("diagnostics");
        if (!all.empty())
            line("  {}", wrap_words(diagnostic_line(all[0]), 4));
    }

    void first_mistake()
    {
        for (auto const& [name, function] : after_.at("functions").items())
            for (auto const& check : function.at("checks"))
                if (!check.at("hint").is_null())
                    return mistake(name, function, check);
        line("{}", say(all_right));
    }

    void mistake(std::string const& name, Report const& function, Report const& check)
    {
        line("  {}: {}", name, text(check.at("name")));
        if (auto const& worst = check.at("worst_input"); !worst.is_null()) {
            labelled(input, text(worst.at("input")));
            labelled(measured, text(worst.at("measured")));
        }
        labelled(hint, phrase(check.at("hint")));
        if (function.contains("mistake"))
            labelled(cause, phrase(function.at("mistake")));
    }

    void labelled(Term label, std::string const& words) { line("    {:<10}{}", say(label), wrap_words(words, 14)); }

    Report const* before_;
    Report const& after_;
};
}  // namespace

std::string changes_to_text(Report const* before, Report const& after, Language language)
{
    return ChangesPrinter(before, after, language).print();
}
}  // namespace testat
