#include "checks/remarks.h"

#include "answers.h"
#include "checks/races.h"

#include <algorithm>

namespace testat {
namespace {
constexpr double slow_s = 0.5;    ///< more than all unit checks of a function take that is not slow
constexpr double leak_bytes = 8;  ///< for each call on average; the smallest block takes 32

/// The unit checks of one function.
struct Asked {
    Function function{};
    std::vector<Answers const*> checks;

    std::uint32_t count() const
    {
        std::uint32_t sum = 0;
        for (auto const* check : checks)
            sum += check->group.count;
        return sum;
    }
};

bool is_well_behaved(Asked const& asked)
{
    double work_s = 0;
    for (auto const* check : asked.checks) {
        if (check->status.ended != Ended::answered)
            return false;
        work_s += check->status.work_s;
    }
    return !asked.checks.empty() && work_s < slow_s;
}

/// The functions that are worth asking again, in the order of the sheet.
std::vector<Asked> asked_functions(Observations const& units)
{
    std::vector<Asked> all;
    for (Function f : every_function()) {
        Asked asked{f, {}};
        for (auto const& [name, answers] : units.groups)
            if (answers.group.under_test == f)
                asked.checks.push_back(&answers);
        if (is_well_behaved(asked))
            all.push_back(std::move(asked));
    }
    return all;
}

std::string name_of(Function function)
{
    return std::string(info(function).name);
}

// --- State between calls, memory read before it is written, leaks --------------------------------------------------

std::string again_name(Function function)
{
    return "again/" + name_of(function);
}

bool writes_variables(Function function, Observations const& again)
{
    Answers const* const answers = again.find(again_name(function));
    return answers != nullptr && answers->status.wrote != 0;
}

/// All questions of a function in reverse order.
Group reversed(Asked const& asked)
{
    Group group = asked.checks.front()->group;
    group.name = again_name(asked.function);
    group.fill = other_fill;
    group.twice = true;
    group.count = asked.count();
    group.questions.clear();
    std::size_t const size = question_bytes(group.kind);
    for (auto check = asked.checks.rbegin(); check != asked.checks.rend(); ++check) {
        Group const& part = (*check)->group;
        group.words_per_answer = std::max(group.words_per_answer, part.words_per_answer);
        for (std::size_t i = part.count; i-- > 0;)
            group.questions.insert(group.questions.end(), part.questions.begin() + std::ptrdiff_t(i * size),
                                   part.questions.begin() + std::ptrdiff_t((i + 1) * size));
    }
    return group;
}

bool same_answers(Asked const& asked, Answers const& again)
{
    std::uint32_t behind = asked.count();
    for (auto const* check : asked.checks)
        for (std::uint32_t i = 0; i < check->group.count; ++i)
            if (!same_words(*check, i, again, --behind))
                return false;
    return true;
}

/// Nothing can be said where the time or the probe has run out.
bool is_known(Answers const& answers)
{
    Ended const ended = answers.status.ended;
    return ended != Ended::timed_out && ended != Ended::lost && ended != Ended::not_loaded;
}

bool differs_when_reversed(Asked const& asked, Observations const& again)
{
    Answers const* const answers = again.find(again_name(asked.function));
    if (answers == nullptr || !is_known(*answers))
        return false;
    return answers->status.ended != Ended::answered || !same_answers(asked, *answers);
}

Group filled_otherwise(Answers const& check)
{
    Group group = check.group;
    group.name = "filled/" + group.name;
    group.fill = other_fill;
    return group;
}

bool differs_when_filled(Asked const& asked, Observations const& differences)
{
    return std::any_of(asked.checks.begin(), asked.checks.end(), [&](Answers const* check) {
        Answers const* const filled = differences.find(filled_otherwise(*check).name);
        return filled != nullptr && is_known(*filled) &&
               (filled->status.ended != Ended::answered || filled->words != check->words);
    });
}

/// Whether the reasons could be told apart.
bool was_looked_into(Asked const& asked, Observations const& differences)
{
    return std::all_of(asked.checks.begin(), asked.checks.end(), [&](Answers const* check) {
        Answers const* const filled = differences.find(filled_otherwise(*check).name);
        return filled != nullptr && is_known(*filled);
    });
}

bool leaks(Asked const& asked, Observations const& again)
{
    Answers const* const answers = again.find(again_name(asked.function));
    return answers != nullptr && answers->status.ended == Ended::answered &&
           answers->status.kept >= leak_bytes * asked.count();
}

// --- Words -----------------------------------------------------------------------------------------------------------

Remark depends_on_earlier_calls()
{
    return {"depends_on_earlier_calls",
            {},
            {"Das Ergebnis hängt von früheren Aufrufen ab: Dieselben Eingaben in anderer Reihenfolge ergeben andere "
             "Werte. Variablen, die static oder global sind, behalten ihren Wert von Aufruf zu Aufruf.",
             "The result depends on earlier calls: the same inputs in another order give other values. Variables that "
             "are static or global keep their value from call to call."}};
}

Remark differs_between_runs()
{
    return {
        "differs_between_runs",
        {},
        {"Dieselben Eingaben ergeben in zwei Läufen verschiedene Werte: Es wird Speicher gelesen, in den niemand "
         "geschrieben hat. Ist jede Variable gesetzt, bevor sie gelesen wird, und jeder Index im erlaubten Bereich?",
         "The same inputs give different values in two runs: memory is read that nobody has written to. Is every "
         "variable set before it is read, and every index in range?"}};
}

Remark leaks()
{
    return {"leaks",
            {},
            {"Der belegte Speicher wächst mit jedem Aufruf: Was mit new geholt wird, muss mit delete zurückgegeben "
             "werden (std::vector und std::make_shared tun das selbst); was global ist, darf nicht ohne Ende wachsen.",
             "Memory in use grows with every call: what comes from new must go back by delete (std::vector and "
             "std::make_shared do so by themselves); what is global must not grow for ever."}};
}
}  // namespace

void ask_again(Request& request, Observations const& units, std::vector<TextureData> const& textures)
{
    auto const all = asked_functions(units);
    if (all.empty())
        return;
    request.textures = textures;
    for (auto const& asked : all)
        request.groups.push_back(reversed(asked));
}

void ask_about_differences(Request& request, Observations const& units, Observations const& again,
                           std::vector<TextureData> const& textures)
{
    auto const all = asked_functions(units);
    std::size_t const before = request.groups.size();
    for (auto const& asked : all)
        if (differs_when_reversed(asked, again))
            for (auto const* check : asked.checks)
                request.groups.push_back(filled_otherwise(*check));
    FunctionSet well_behaved;
    FunctionSet writing;
    for (auto const& asked : all) {
        well_behaved = well_behaved.with(asked.function);
        if (writes_variables(asked.function, again))
            writing = writing.with(asked.function);
    }
    ask_about_races(request, well_behaved, writing);
    if (request.groups.size() > before)
        request.textures = textures;
}

std::vector<Remark> find_remarks(Observations const& units, Observations const& again, Observations const& differences)
{
    Remark calls = depends_on_earlier_calls();
    Remark runs = differs_between_runs();
    Remark leak = leaks();
    for (auto const& asked : asked_functions(units)) {
        if (differs_when_filled(asked, differences))
            runs.functions.push_back(asked.function);
        else if (differs_when_reversed(asked, again) && was_looked_into(asked, differences))
            calls.functions.push_back(asked.function);
        if (leaks(asked, again))
            leak.functions.push_back(asked.function);
    }
    std::vector<Remark> remarks;
    auto const add = [&](Remark& remark) {
        if (!remark.functions.empty())
            remarks.push_back(std::move(remark));
    };
    add(calls);
    add(runs);
    // What differs anyway says nothing about threads.
    if (auto race = remarks.empty() ? find_races(differences) : std::nullopt)
        remarks.push_back(std::move(*race));
    add(leak);
    return remarks;
}
}  // namespace testat
