#include "checks/trouble.h"

#include "text.h"

#include <fmt/format.h>

#include <csignal>
#include <cstring>

namespace testat {
namespace {
/// The beginning of what was printed, if anything.
Phrase printed_text(GroupStatus const& status)
{
    std::string const text = clean_text(status.output);
    if (text.empty())
        return {};
    return {" Ausgabe: " + text, " Output: " + text};
}

Phrase describe_signal(int signal)
{
    switch (signal) {
        case SIGSEGV:
        case SIGBUS:
            return {"Absturz: Zugriff auf fremden Speicher oder Endlos-Rekursion (SIGSEGV).",
                    "Crash: access to memory that is not yours, or endless recursion (SIGSEGV)."};
        case SIGABRT:
            return {"Absturz: abgebrochen (SIGABRT), zum Beispiel durch eine verletzte Zusicherung (cg_assert).",
                    "Crash: aborted (SIGABRT), for example by a failed assertion (cg_assert)."};
        case SIGFPE:
            return {"Absturz: Division einer ganzen Zahl durch null (SIGFPE).",
                    "Crash: division of an integer by zero (SIGFPE)."};
        default:
            return {fmt::format("Absturz: Signal {}.", signal), fmt::format("Crash: signal {}.", signal)};
    }
}

Phrase describe_end(GroupStatus const& status)
{
    std::string const text = clean_text(status.text);
    switch (status.ended) {
        case Ended::signal:
            return describe_signal(status.code);
        case Ended::exit:
            return {fmt::format("Die Funktion hat das Programm mit exit({}) beendet.", status.code),
                    fmt::format("The function ended the program with exit({}).", status.code)};
        case Ended::exception:
            return {"Die Funktion hat eine Ausnahme geworfen: " + (text.empty() ? "keine std::exception" : text),
                    "The function threw an exception: " + (text.empty() ? "no std::exception" : text)};
        case Ended::timed_out:
            return {"Zeitlimit: Die Funktion wurde nicht fertig (Endlosschleife?).",
                    "Time limit: the function did not finish (an endless loop?)."};
        case Ended::not_loaded:
            return {"Die Datei lässt sich nicht laden: " + text, "The file cannot be loaded: " + text};
        default:
            return {"Die Funktion hat den Prozess beendet, in dem sie lief.",
                    "The function ended the process that it ran in."};
    }
}
}  // namespace

std::optional<Phrase> describe_trouble(GroupStatus const& status)
{
    Phrase const output = printed_text(status);
    if (status.ended != Ended::answered) {
        Phrase const end = describe_end(status);
        return Phrase{end.de + output.de, end.en + output.en};
    }
    if (status.printed == 0)
        return std::nullopt;
    return Phrase{fmt::format("Hinweis: Die Funktion gibt Text aus ({} Byte oder mehr), das kostet Zeit.{}",
                              status.printed, output.de),
                  fmt::format("Note: the function prints text ({} bytes or more), which takes time.{}", status.printed,
                              output.en)};
}

std::string name_end(GroupStatus const& status)
{
    switch (status.ended) {
        case Ended::signal: {
            char const* name = sigabbrev_np(status.code);
            return name != nullptr ? std::string("SIG") + name : fmt::format("signal {}", status.code);
        }
        case Ended::exit:
            return fmt::format("exit({})", status.code);
        case Ended::exception:
            return "exception: " + clean_text(status.text);
        case Ended::timed_out:
            return "timeout";
        case Ended::not_loaded:
            return "dlopen: " + clean_text(status.text);
        default:
            return "-";
    }
}
}  // namespace testat
