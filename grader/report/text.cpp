#include "report/text.h"

#include "report/reading.h"
#include "report/wrap.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

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
constexpr Term changed_by_hand{"Von Hand geändert", "Changed by hand"};
constexpr Term task_term{"Aufgabe", "Task"};
constexpr Term input{"Eingabe", "input"};
constexpr Term measured{"Ergebnis", "measured"};
constexpr Term expected{"erwartet", "expected"};
constexpr Term hint{"Hinweis", "hint"};
constexpr Term cause{"Ursache", "cause"};
constexpr Term pictures_term{"Bilder", "Pictures"};
constexpr Term no_sandbox{"Ohne Käfig ausgeführt (--no-sandbox)", "Run without a cage (--no-sandbox)"};
constexpr Term remarks_term{"Anmerkungen (ändern keine Punkte)", "Remarks (they change no points)"};
constexpr Term not_gradable{"NICHT BEWERTBAR (kein Fehler der Abgabe)", "NOT GRADABLE (not the upload's fault)"};
constexpr Term broken_functions{
    "Die Datei lässt sich nicht übersetzen oder binden. Der erste Fehler jeder betroffenen Stelle:",
    "The file does not compile or link. The first error of each place that is to blame:"};
constexpr Term fix_first{"Zuerst beheben:", "Fix first:"};
constexpr Term line_term{"Zeile", "line"};
constexpr Term unofficially{"inoffiziell für das, was kompiliert", "unofficially, for what compiles"};
constexpr Term unofficial_table{
    "Inoffiziell: was die Funktionen, die kompilieren, einbringen würden. Das zählt erst, wenn die ganze Datei "
    "kompiliert.",
    "Unofficially: what the functions that compile would earn. It counts only once the whole file compiles."};
constexpr Term nothing_alone{"Auch einzeln ließ sich keine Funktion bewerten.",
                             "No function could be graded by itself either."};
constexpr Term public_only{"Nur die öffentlichen Prüfungen sind gezählt; die Tutoren prüfen mehr.",
                           "Only the public checks are counted; the tutors check more."};

/// What a terminal is told before words; afterwards it is told to forget.
constexpr char bold[] = "\x1b[1m";
constexpr char green[] = "\x1b[32m";
constexpr char red[] = "\x1b[31m";
constexpr char yellow[] = "\x1b[33m";
constexpr char forget[] = "\x1b[0m";

class ReportPrinter : Printer {
public:
    ReportPrinter(Report const& report, Language language, Ink ink)
        : Printer(language), report_(report), reading_(report), language_(language), ink_(ink)
    {
    }

    std::string print()
    {
        if (report_.at("status") == "not_gradable")
            return fmt::format("{}\n  {}\n", say(not_gradable), text(report_.at("error")));
        headline();
        sandbox();
        first_fix();
        diagnostics();
        table();
        first_mistakes();
        pictures();
        remarks();
        return std::move(out_);
    }

private:
    std::string paint(char const* colour, std::string const& words) const
    {
        return ink_ == Ink::plain ? words : colour + words + forget;
    }

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
        bool const passed = points.at("passed_60_percent").get<bool>();
        line("{} ({})",
             paint(bold, fmt::format("{}: {:.2f} {} {:.2f} {}", text(report_.at("submission").at("file")),
                                     points.at("earned").get<double>(), say(of), points.at("max").get<double>(),
                                     say(points_term))),
             paint(passed ? green : red, say(passed ? pass : fail)));
        for (auto const& policy : report_.at("policy").at("applied"))
            line("  {}", wrap_words(fmt::format("{}: {}; {}", say(rule),
                                                say(policy == "crashes" ? crashes : not_compiled), alternative()),
                                    4));
        if (reading_.is_public_only())
            line("  {}", say(public_only));
        for (auto const& change : reading_.by_hand())
            line("  {}", wrap_words(fmt::format("{}: {}", say(changed_by_hand), text(change)), 4));
    }

    /// What does not compile is told below, place by place.
    void first_fix()
    {
        auto const fix = reading_.first_fix();
        if (!fix || !reading_.builds())
            return;
        std::string const place = fix->line > 0 ? fmt::format(", {} {}", say(line_term), fix->line) : "";
        std::string const what = language_ == Language::de ? fix->what.de : fix->what.en;
        line("  {} {}", paint(yellow, say(fix_first)),
             wrap_words(fmt::format("{}{} (-{:.2f}): {}", fix->function, place, fix->lost, what), 4,
                        columns_of(say(fix_first)) + 3));
    }

    /// What there would be without the sheet's rule.
    std::string alternative() const
    {
        if (!reading_.has_unofficial())
            return fmt::format("{}: {:.2f}", say(without_rule),
                               report_.at("policy").at("earned_without").get<double>());
        auto const& points = report_.at("unofficial");
        return fmt::format("{}: {:.2f} {} {:.2f}", say(unofficially), points.at("earned").get<double>(), say(of),
                           points.at("max").get<double>());
    }

    void diagnostics()
    {
        auto const& build = report_.at("build");
        if (build.at("ok").get<bool>())
            return;
        if (reading_.has_unofficial())
            return broken_list();
        line("\n{}", say(does_not_build));
        auto const& all = build.at("diagnostics");
        for (std::size_t i = 0; i < std::min(shown_diagnostics, all.size()); ++i)
            line("  {}", wrap_words(diagnostic_line(all[i]), 4));
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

    std::string verdict(std::string const& name) const
    {
        bool const is_whole = reading_.lost_by(name) <= 0;
        return paint(is_whole ? green : reading_.earned_by(name) > 0 ? yellow : red, say(reading_.word_for(name)));
    }

    /// Unofficial points where there are any.
    void table()
    {
        for (auto const& task : report_.at("tasks")) {
            out_ += "\n";
            points_line(fmt::format("{} {}) {}", say(task_term), text(task.at("id")), phrase(task.at("title"))),
                        reading_.earned_in(task), task.at("max"));
            for (auto const& [name, function] : report_.at("functions").items())
                if (function.at("task") == task.at("id"))
                    points_line(fmt::format("    {:<40}{}", name, verdict(name)), reading_.earned_by(name),
                                function.at("max"));
        }
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
        line("\n{}", paint(bold, fmt::format("{}: {}", function, text(check.at("name")))));
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
        if (!reading_.was_run())
            return;
        bool any = false;
        for (auto const& picture : report_.at("pictures")) {
            if (reading_.finding(picture, language_).empty())
                continue;
            if (!any)
                line("\n{}", say(pictures_term));
            any = true;
            line("  {:<26}{}", text(picture.at("name")), wrap_words(reading_.finding(picture, language_), 28));
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

    Report const& report_;
    Reading reading_;
    Language language_;
    Ink ink_;
};
}  // namespace

std::string report_to_text(Report const& report, Language language, Ink ink)
{
    return ReportPrinter(report, language, ink).print();
}

Ink ink_of_stdout()
{
    char const* const no_colour = std::getenv("NO_COLOR");
    char const* const terminal = std::getenv("TERM");
    bool const refused =
        (no_colour != nullptr && *no_colour != '\0') || terminal == nullptr || std::strcmp(terminal, "dumb") == 0;
    return isatty(STDOUT_FILENO) == 1 && !refused ? Ink::coloured : Ink::plain;
}
}  // namespace testat
