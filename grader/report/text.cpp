#include "report/text.h"

#include "report/printer.h"
#include "report/wrap.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat {
namespace {
constexpr std::size_t label_columns = 12;

constexpr Term of{"von", "of"};
constexpr Term points_term{"Punkten", "points"};
constexpr Term pass{"60 % erreicht", "60 % reached"};
constexpr Term fail{"60 % nicht erreicht", "below 60 %"};
constexpr Term rule{"Regel des Übungsblatts", "rule of the sheet"};
constexpr Term not_compiled{"was nicht kompiliert, bekommt 0 Punkte", "what does not compile gets 0 points"};
constexpr Term crashes{"was beim Erzeugen der Bilder abstürzt, bekommt 0 Punkte",
                       "what crashes while making the pictures gets 0 points"};
constexpr Term without_rule{"ohne diese Regel", "without this rule"};
constexpr Term task_term{"Aufgabe", "Task"};
constexpr Term input{"Eingabe", "input"};
constexpr Term measured{"Ergebnis", "measured"};
constexpr Term expected{"erwartet", "expected"};
constexpr Term hint{"Hinweis", "hint"};
constexpr Term cause{"Ursache", "cause"};
constexpr Term pictures_term{"Bilder", "Pictures"};
constexpr Term no_sandbox{"Ohne Käfig ausgeführt (--no-sandbox)", "Run without a cage (--no-sandbox)"};
constexpr Term remarks_term{"Anmerkungen (ändern keine Punkte)", "Remarks (they change no points)"};
constexpr Term differs{"weicht ab wegen", "differs because of"};
constexpr Term isolated{"{} Pixel falsch, auch wenn alles andere stimmt", "{} pixel{} wrong even if all else is right"};
constexpr Term not_made{"konnte nicht erzeugt werden", "could not be made"};
constexpr Term not_gradable{"NICHT BEWERTBAR (kein Fehler der Abgabe)", "NOT GRADABLE (not the upload's fault)"};
constexpr Term broken_functions{
    "Die Datei lässt sich nicht übersetzen oder binden. Der erste Fehler jeder betroffenen Stelle:",
    "The file does not compile or link. The first error of each place that is to blame:"};
constexpr Term line_term{"Zeile", "line"};
constexpr Term broken{"kompiliert nicht", "does not compile"};
constexpr Term not_judged{"nicht bewertet", "not judged"};
constexpr Term unofficially{"inoffiziell für das, was kompiliert", "unofficially, for what compiles"};
constexpr Term unofficial_table{
    "Inoffiziell: was die Funktionen, die kompilieren, einbringen würden. Das zählt erst, wenn die ganze Datei "
    "kompiliert.",
    "Unofficially: what the functions that compile would earn. It counts only once the whole file compiles."};
constexpr Term nothing_alone{"Auch einzeln ließ sich keine Funktion bewerten.",
                             "No function could be graded by itself either."};
constexpr Term public_only{"Nur die öffentlichen Prüfungen sind gezählt; die Tutoren prüfen mehr.",
                           "Only the public checks are counted; the tutors check more."};

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

std::string join(Report const& names)
{
    std::string all;
    for (auto const& name : names)
        all += (all.empty() ? "" : ", ") + name.get<std::string>();
    return all;
}

class ReportPrinter : Printer {
public:
    ReportPrinter(Report const& report, Language language) : Printer(language), report_(report) {}

    std::string print()
    {
        if (report_.at("status") == "not_gradable")
            return fmt::format("{}\n  {}\n", say(not_gradable), text(report_.at("error")));
        headline();
        sandbox();
        diagnostics();
        table();
        first_mistakes();
        pictures();
        remarks();
        return std::move(out_);
    }

private:
    void labelled(Term label, std::string const& words)
    {
        std::string const padding(label_columns - 2 - columns_of(say(label)), ' ');
        line("  {}{}{}", say(label), padding, wrap_words(words, label_columns));
    }

    void sandbox()
    {
        if (!report_.value("sandbox", true))
            line("  {}", wrap_words(say(no_sandbox), 2));
    }

    void headline()
    {
        auto const& points = report_.at("points");
        line("{}: {:.2f} {} {:.2f} {} ({})", text(report_.at("submission").at("file")),
             points.at("earned").get<double>(), say(of), points.at("max").get<double>(), say(points_term),
             say(points.at("passed_60_percent").get<bool>() ? pass : fail));
        for (auto const& policy : report_.at("policy").at("applied"))
            line("  {}", wrap_words(fmt::format("{}: {}; {}", say(rule),
                                                say(policy == "crashes" ? crashes : not_compiled), alternative()),
                                    4));
        if (is_public_only())
            line("  {}", say(public_only));
    }

    /// What there would be without the sheet's rule.
    std::string alternative() const
    {
        if (!has_unofficial())
            return fmt::format("{}: {:.2f}", say(without_rule),
                               report_.at("policy").at("earned_without").get<double>());
        auto const& points = report_.at("unofficial");
        return fmt::format("{}: {:.2f} {} {:.2f}", say(unofficially), points.at("earned").get<double>(), say(of),
                           points.at("max").get<double>());
    }

    bool has_unofficial() const { return report_.contains("unofficial"); }

    bool was_run() const
    {
        return has_unofficial() || !report_.at("run_time").empty() || report_.at("build").at("ok").get<bool>();
    }

    bool is_public_only() const
    {
        for (auto const& function : report_.at("functions"))
            for (auto const& check : function.at("checks"))
                if (check.at("visibility") == "hidden")
                    return false;
        return true;
    }

    void diagnostics()
    {
        auto const& build = report_.at("build");
        if (build.at("ok").get<bool>())
            return;
        if (has_unofficial())
            return broken_list();
        line("\n{}", say(does_not_build));
        auto const& all = build.at("diagnostics");
        for (std::size_t i = 0; i < std::min(shown_diagnostics, all.size()); ++i)
            line("  {}", wrap_words(diagnostic(all[i]), 4));
        if (report_.at("policy").at("earned_without") == 0)
            line("{}", say(nothing_alone));
    }

    void broken_list()
    {
        line("\n{}", wrap_words(say(broken_functions), 0));
        Report const& unofficial = report_.at("unofficial");
        for (auto const& error : unofficial.value("left_out", Report::array()))
            broken_place("", error);
        for (auto const& [name, error] : unofficial.at("broken").items())
            broken_place(name, error);
        line("\n{}", wrap_words(say(unofficial_table), 0));
    }

    void broken_place(std::string place, Report const& error)
    {
        if (int const number = error.at("line").get<int>(); number > 0)
            place += fmt::format("{}{} {}", place.empty() ? "" : ", ", say(line_term), number);
        line("  {}", wrap_words(fmt::format("{}{}{}", place, place.empty() ? "" : ": ", text(error.at("message"))), 4));
    }

    void points_line(std::string const& left, double earned, Report const& max)
    {
        std::string const padding(std::max<std::size_t>(columns - 14, columns_of(left)) - columns_of(left), ' ');
        line("{}{}{:>5.2f} / {:>5.2f}", left, padding, earned, max.get<double>());
    }

    /// Unofficial points where there are any.
    void table()
    {
        for (auto const& task : report_.at("tasks")) {
            out_ += "\n";
            points_line(fmt::format("{} {}) {}", say(task_term), text(task.at("id")), phrase(task.at("title"))),
                        earned_in(task), task.at("max"));
            for (auto const& [name, function] : report_.at("functions").items())
                if (function.at("task") == task.at("id"))
                    points_line(fmt::format("    {:<40}{}", name, say(word_for(name))), earned_by(name),
                                function.at("max"));
        }
    }

    /// The function as the table shows it; null if it is broken.
    Report const* graded(std::string const& name) const
    {
        auto const& functions = has_unofficial() ? report_.at("unofficial").at("functions") : report_.at("functions");
        auto const found = functions.find(name);
        return found == functions.end() ? nullptr : &*found;
    }

    double earned_by(std::string const& name) const
    {
        auto const* const function = graded(name);
        return function == nullptr ? 0 : function->at("earned").get<double>();
    }

    double earned_in(Report const& task) const
    {
        double sum = 0;
        for (auto const& [name, function] : report_.at("functions").items())
            sum += function.at("task") == task.at("id") ? earned_by(name) : 0;
        return sum;
    }

    Term word_for(std::string const& name) const
    {
        bool const missing = report_.at("functions").at(name).at("verdict") == "missing";
        if (auto const* const function = graded(name))
            return was_run() || missing ? verdict_term(text(function->at("verdict"))) : not_judged;
        return missing ? verdict_term("missing") : broken;
    }

    /// Of each function the first check that failed, or that has something to say.
    void first_mistakes()
    {
        for (auto const& [name, function] : report_.at("functions").items())
            for (auto const& check : function.at("checks"))
                if (!check.at("hint").is_null()) {
                    first_mistake(name, check);
                    if (function.contains("mistake"))
                        labelled(cause, phrase(function.at("mistake")));
                    break;
                }
    }

    void first_mistake(std::string const& function, Report const& check)
    {
        line("\n{}: {}", function, text(check.at("name")));
        if (auto const& worst = check.at("worst_input"); !worst.is_null()) {
            labelled(input, text(worst.at("input")));
            labelled(measured, text(worst.at("measured")));
        }
        // A check that ended before its time has measured just that.
        bool const answered =
            !check.at("worst_input").is_null() && check.at("worst_input").at("measured") != check.at("detail");
        if (!check.at("detail").is_null() && answered)
            labelled(expected, text(check.at("detail")));
        labelled(hint, phrase(check.at("hint")));
    }

    /// Those that differ as submitted or in isolation.
    void pictures()
    {
        if (!was_run())
            return;
        bool any = false;
        for (auto const& picture : report_.at("pictures")) {
            if (finding(picture).empty())
                continue;
            if (!any)
                line("\n{}", say(pictures_term));
            any = true;
            line("  {:<26}{}", text(picture.at("name")), wrap_words(finding(picture), 28));
        }
    }

    void remarks()
    {
        if (!report_.contains("remarks"))
            return;
        line("\n{}", say(remarks_term));
        for (auto const& remark : report_.at("remarks")) {
            std::string const names = join(remark.at("functions"));
            line("  {}", wrap_words(names + (names.empty() ? "" : ": ") + phrase(remark), 4));
        }
    }

    /// Whether nobody has written a function yet, that compiles, whose points depend on the picture.
    bool is_unwritten(Report const& picture) const
    {
        auto const& functions = picture.at("functions");
        return std::all_of(functions.begin(), functions.end(), [&](Report const& name) {
            auto const* const function = graded(text(name));
            return function == nullptr || function->at("verdict") == "missing";
        });
    }

    std::string finding(Report const& picture) const
    {
        std::string result;
        if (picture.contains("explained_by"))
            result = fmt::format("{} {}", say(differs), join(picture.at("explained_by")));
        if (picture.at("score") == 1 || is_unwritten(picture))
            return result;
        auto const outside = picture.at("outside").get<std::size_t>();
        std::string const alone = picture.at("isolated_file").is_null()
                                      ? say(not_made)
                                      : fmt::format(fmt::runtime(say(isolated)), outside, outside == 1 ? "" : "s");
        return result + (result.empty() ? "" : "; ") + alone;
    }

    Report const& report_;
};
}  // namespace

std::string report_to_text(Report const& report, Language language)
{
    return ReportPrinter(report, language).print();
}
}  // namespace testat
