#include "checks/circular.h"

#include "checks/check.h"

#include <algorithm>

namespace testat {
namespace {
/// Functions of the upload are less exact than the reference's, within what is allowed for each.
constexpr double by_far = 100;

bool are_several(FunctionSet functions)
{
    return (functions.bits() & (functions.bits() - 1)) != 0;
}

/// The unit checks of the functions, all of which come from the upload.
Request ask_together(Questions const& questions, FunctionSet functions)
{
    Request request = questions.request;
    auto const is_other = [&](Group const& group) { return !functions.has(group.under_test); };
    request.groups.erase(std::remove_if(request.groups.begin(), request.groups.end(), is_other), request.groups.end());
    for (auto& group : request.groups)
        group.from_upload = functions;
    return request;
}

/// CPU time in seconds: a check that takes less alone, and more together, goes round in circles.
constexpr double quick_s = 0.25;
constexpr double long_s = 1;

bool fails(UnitCheck const& check, Answers const& answers, Answers const* alone, Textures const& textures)
{
    switch (answers.status.ended) {
        case Ended::answered:
            return !(check.judge(answers, textures).error() <= by_far);
        case Ended::timed_out:
            return alone != nullptr && alone->status.cpu_s < quick_s && answers.status.cpu_s > long_s;
        case Ended::lost:
        case Ended::not_loaded:
            return false;
        default:
            return true;
    }
}

/// `prefix`: of the groups' names.
FunctionSet failing(Observations const& observations, Observations const& alone, Textures const& textures,
                    std::string const& prefix = "")
{
    FunctionSet found;
    for (auto const& check : unit_checks())
        if (auto const* answers = observations.find(prefix + check.name);
            answers && fails(check, *answers, alone.find(check.name), textures))
            found = found.with(check.function);
    return found;
}

constexpr char in_company[] = "in_company/";

FunctionSet quick(FunctionSet functions, Observations const& alone)
{
    for (auto const& [name, answers] : alone.groups)
        if (!(answers.status.cpu_s < quick_s))
            functions = functions.without(answers.group.under_test);
    return functions;
}

std::string names(FunctionSet functions)
{
    std::string list;
    for (Function f : every_function())
        if (functions.has(f))
            list += (list.empty() ? "" : ", ") + std::string(info(f).name);
    return list;
}
}  // namespace

void ask_in_company(Request& request, FunctionSet functions, Observations const& alone, Questions const& questions)
{
    Request const together = ask_together(questions, quick(functions, alone));
    for (Group group : together.groups) {
        group.name = in_company + group.name;
        request.groups.push_back(std::move(group));
    }
    if (!together.groups.empty())
        request.textures = questions.request.textures;
}

bool fail_in_company(Observations const& observations, Observations const& alone, Questions const& questions)
{
    return failing(observations, alone, questions.request.textures, in_company) != FunctionSet();
}

FunctionSet find_circular(FunctionSet functions, Observations const& alone, Questions const& questions, Ask const& ask)
{
    auto const failing_together = [&](FunctionSet together) {
        return are_several(together)
                   ? failing(ask(ask_together(questions, together)), alone, questions.request.textures)
                   : FunctionSet();
    };
    // What only calls something whose mistake no check of its own shows is right again once that is the reference's.
    for (FunctionSet left = failing_together(functions); left != functions; left = failing_together(functions))
        functions = left;
    // What only calls one of the others makes none of them right when it is the reference's itself.
    for (Function f : every_function())
        if (functions.has(f) && failing_together(functions.without(f)) == functions.without(f))
            functions = functions.without(f);
    return are_several(functions) ? functions : FunctionSet();
}

void take_credit(CheckResults& results, FunctionSet circular)
{
    for (auto& check : results.checks)
        if (circular.has(check.function)) {
            std::string const others = names(circular.without(check.function));
            check.passed = false;
            check.detail = "right only while " + others + " is the reference's, and so the other way round";
            check.trouble =
                Phrase{"Die Funktion stimmt nur, solange " + others +
                           " nicht aus Ihrer Datei kommt: Jede verlässt sich auf die andere, und keine rechnet.",
                       "The function is right only while " + others +
                           " is not yours: each relies on the other, and none of them computes."};
        }
}
}  // namespace testat
