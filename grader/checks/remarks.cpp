#include "checks/remarks.h"

#include "answers.h"
#include "checks/textures.h"

#include <algorithm>

namespace testat {
namespace {
constexpr std::uint32_t other_fill = 0xc1;  ///< -24.22 as float, a negative int, no valid pointer
constexpr std::uint32_t several = 4;        ///< threads
constexpr double slow_s = 0.5;              ///< more than all unit checks of a function take that is not slow
constexpr double leak_bytes = 8;            ///< for each call on average; the smallest block takes 32

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

FunctionSet set_of(std::vector<Asked> const& all)
{
    FunctionSet set;
    for (auto const& asked : all)
        set = set.with(asked.function);
    return set;
}

Answers const* find(Observations const& observations, std::string const& name)
{
    auto const found = observations.groups.find(name);
    return found == observations.groups.end() ? nullptr : &found->second;
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

/// Whether two answers have the same words, as many as the first one has.
bool same_words(Answers const& a, std::uint32_t index_a, Answers const& b, std::uint32_t index_b)
{
    auto const* begin_a = &a.words[std::size_t(index_a) * a.group.words_per_answer];
    auto const* begin_b = &b.words[std::size_t(index_b) * b.group.words_per_answer];
    return std::equal(begin_a, begin_a + a.group.words_per_answer, begin_b);
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
    Answers const* const answers = find(again, again_name(asked.function));
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
        Answers const* const filled = find(differences, filled_otherwise(*check).name);
        return filled != nullptr && is_known(*filled) &&
               (filled->status.ended != Ended::answered || filled->words != check->words);
    });
}

/// Whether the reasons could be told apart.
bool was_looked_into(Asked const& asked, Observations const& differences)
{
    return std::all_of(asked.checks.begin(), asked.checks.end(), [&](Answers const* check) {
        Answers const* const filled = find(differences, filled_otherwise(*check).name);
        return filled != nullptr && is_known(*filled);
    });
}

bool leaks(Asked const& asked, Observations const& again)
{
    Answers const* const answers = find(again, again_name(asked.function));
    return answers != nullptr && answers->status.ended == Ended::answered &&
           answers->status.kept >= leak_bytes * asked.count();
}

// --- Races -----------------------------------------------------------------------------------------------------------

/// Between them they call every function that is called while pixels are rendered. As the framework numbers filters.
constexpr std::uint32_t nearest = 0;
constexpr std::uint32_t trilinear = 2;
constexpr std::pair<std::uint32_t, Wrap> modes[] = {{trilinear, Wrap::repeat}, {nearest, Wrap::clamp}};

using Threads = std::vector<std::uint32_t>;

/// With one thread second, so that the several begin with nothing computed yet.
Threads const raced{several, 1, several, several, several, several};
Threads const not_raced{1, 1};
constexpr std::uint32_t single = 1;  ///< index of the rendering with one thread, in both

char const threads_name[] = "threads";
char const once_name[] = "threads/one";
char const once_filled_name[] = "threads/one_filled";

Group rendering_group(std::string const& name, FunctionSet from_upload, Threads const& threads)
{
    std::vector<RenderingQuestion> questions;
    for (auto const& [filter, wrap] : modes)
        for (std::uint32_t count : threads)
            questions.push_back({static_cast<std::uint32_t>(TestTexture::noise_square), filter,
                                 static_cast<std::uint32_t>(wrap), count});
    Group group = make_group(Kind::rendering, questions);
    group.name = name;
    group.from_upload = from_upload;
    return group;
}

std::string alone_name(Function function)
{
    return std::string(threads_name) + "/" + name_of(function);
}

std::uint32_t renderings_each(Answers const& answers)
{
    return answers.group.count / std::uint32_t(std::size(modes));
}

/// Whether all renderings of a mode are the same.
bool all_same(Answers const& answers)
{
    std::uint32_t const each = renderings_each(answers);
    for (std::uint32_t i = 0; i < answers.group.count; ++i)
        if (!same_words(answers, i, answers, i / each * each + single))
            return false;
    return true;
}

bool writes_variables(Function function, Observations const& again)
{
    Answers const* const answers = find(again, again_name(function));
    return answers != nullptr && answers->status.wrote != 0;
}

bool may_race(Answers const* answers)
{
    if (answers == nullptr || answers->status.ended == Ended::lost || answers->status.ended == Ended::not_loaded)
        return false;
    return answers->status.ended != Ended::answered || !all_same(*answers);
}

/// Whether the renderings with one thread are those of `once`.
bool same_singles(Answers const& answers, Answers const& once)
{
    for (std::uint32_t mode = 0; mode < std::size(modes); ++mode)
        if (!same_words(once, mode * renderings_each(once) + single, answers, mode * renderings_each(answers) + single))
            return false;
    return true;
}

/// Whether with one thread all goes well, whatever came before and whatever memory holds.
bool is_steady_alone(Observations const& differences)
{
    Answers const* const once = find(differences, once_name);
    Answers const* const filled = find(differences, once_filled_name);
    for (auto const* answers : {once, filled})
        if (answers == nullptr || answers->status.ended != Ended::answered || !all_same(*answers))
            return false;
    Answers const* const threads = find(differences, threads_name);
    return same_singles(*filled, *once) && (threads->status.ended != Ended::answered || same_singles(*threads, *once));
}

std::vector<Function> racing_alone(Observations const& differences)
{
    std::vector<Function> found;
    for (Function f : every_function())
        if (may_race(find(differences, alone_name(f))))
            found.push_back(f);
    return found;
}

/// Nothing where no variables are written, because then there is nothing to race for.
void ask_about_races(Request& request, std::vector<Asked> const& all, Observations const& again)
{
    std::size_t const before = request.groups.size();
    for (auto const& asked : all)
        if (writes_variables(asked.function, again))
            request.groups.push_back(
                rendering_group(alone_name(asked.function), FunctionSet::only(asked.function), raced));
    if (request.groups.size() == before)
        return;
    request.groups.push_back(rendering_group(threads_name, set_of(all), raced));
    for (auto const& [name, fill] : {std::pair(once_name, usual_fill), {once_filled_name, other_fill}}) {
        request.groups.push_back(rendering_group(name, set_of(all), not_raced));
        request.groups.back().fill = fill;
    }
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

Remark races()
{
    return {"races",
            {},
            {"Mit mehreren Threads geht es anders aus als mit einem, jedes Mal verschieden: Mehrere Aufrufe benutzen "
             "gleichzeitig dieselbe Variable (static, global), und mindestens einer schreibt.",
             "With several threads it ends differently than with one, and differently each time: several calls use the "
             "same variable (static, global) at once, and at least one writes to it."}};
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
    ask_about_races(request, all, again);
    if (request.groups.size() > before)
        request.textures = textures;
}

std::vector<Remark> find_remarks(Observations const& units, Observations const& again, Observations const& differences)
{
    Remark calls = depends_on_earlier_calls();
    Remark runs = differs_between_runs();
    Remark race = races();
    Remark leak = leaks();
    for (auto const& asked : asked_functions(units)) {
        if (differs_when_filled(asked, differences))
            runs.functions.push_back(asked.function);
        else if (differs_when_reversed(asked, again) && was_looked_into(asked, differences))
            calls.functions.push_back(asked.function);
        if (leaks(asked, again))
            leak.functions.push_back(asked.function);
    }
    // What differs anyway says nothing about threads.
    bool const steady = calls.functions.empty() && runs.functions.empty();
    bool const is_race = steady && may_race(find(differences, threads_name)) && is_steady_alone(differences);
    if (is_race)
        race.functions = racing_alone(differences);
    std::vector<Remark> remarks;
    for (auto* remark : {&calls, &runs, &race, &leak})
        if (!remark->functions.empty() || (remark == &race && is_race))
            remarks.push_back(std::move(*remark));
    return remarks;
}
}  // namespace testat
