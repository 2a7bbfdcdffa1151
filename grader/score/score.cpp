#include "score/score.h"

#include <algorithm>
#include <cmath>

namespace testat {
namespace {
CheckResult const* find_result(CheckResults const& results, std::string const& name)
{
    auto const found =
        std::find_if(results.checks.begin(), results.checks.end(), [&](auto const& r) { return r.name == name; });
    return found == results.checks.end() ? nullptr : &*found;
}

bool passes(CheckResults const& results, RubricCheck const& check)
{
    auto const* result = find_result(results, check.name);
    return result != nullptr && result->passed;
}

double unit_share(CheckResults const& results, RubricFunction const& function)
{
    double share = 0;
    for (auto const& check : function.checks) {
        bool const passed = passes(results, check);
        if (check.essential && !passed)
            return 0;
        share += passed ? check.weight : 0;
    }
    return share;
}

double picture_share(CheckResults const& results, RubricFunction const& function)
{
    if (function.pictures.empty())
        return 1;
    double sum = 0;
    for (auto const& picture : results.pictures)
        for (auto const& isolated : picture.isolated)
            if (isolated.function == function.function)
                sum += isolated.score;
    return sum / double(function.pictures.size());
}

/// How the function's checks and pictures ended, the most telling end first.
bool any_ended(CheckResults const& results, RubricFunction const& function, std::initializer_list<Ended> ends)
{
    auto const matches = [&](Ended ended) { return std::find(ends.begin(), ends.end(), ended) != ends.end(); };
    for (auto const& check : results.checks)
        if (check.function == function.function && matches(check.ended))
            return true;
    for (auto const& picture : results.pictures)
        for (auto const& isolated : picture.isolated)
            if (isolated.function == function.function && isolated.rendering && matches(isolated.rendering->ended))
                return true;
    return false;
}

/// Of a function of which nothing was run as it stands in the file.
FunctionVerdict unrun_verdict(Build const& build, RubricFunction const& function)
{
    return build.sources.count(function.function) > 0 ? FunctionVerdict::wrong : FunctionVerdict::missing;
}

FunctionVerdict verdict(CheckResults const& results, Build const& build, RubricFunction const& function,
                        FunctionGrade const& grade)
{
    if (build.library.empty())
        return unrun_verdict(build, function);
    if (!build.written().has(function.function))
        return FunctionVerdict::missing;
    if (any_ended(results, function, {Ended::timed_out}))
        return FunctionVerdict::timed_out;
    if (any_ended(results, function, {Ended::signal, Ended::exit, Ended::exception, Ended::not_loaded, Ended::lost}))
        return FunctionVerdict::crashed;
    bool const whole = std::all_of(function.checks.begin(), function.checks.end(),
                                   [&](auto const& check) { return passes(results, check); });
    if (whole && grade.picture == 1)
        return FunctionVerdict::correct;
    return grade.earned > 0 ? FunctionVerdict::partial : FunctionVerdict::wrong;
}

FunctionGrade grade_function(CheckResults const& results, Build const& build, Rubric const& rubric,
                             RubricFunction const& function)
{
    FunctionGrade grade;
    grade.function = function.function;
    grade.max = function.points;
    grade.unit = unit_share(results, function);
    grade.picture = picture_share(results, function);
    grade.earned = round_half_up(grade.max * std::min(grade.unit, (1 + grade.picture) / 2), rubric.rounding);
    grade.verdict = verdict(results, build, function, grade);
    return grade;
}

/// What a function of a file that does not compile has, whatever it would earn alone.
FunctionGrade nothing_earned(Build const& build, RubricFunction const& function)
{
    FunctionGrade grade;
    grade.function = function.function;
    grade.max = function.points;
    grade.picture = picture_share({}, function);
    grade.verdict = unrun_verdict(build, function);
    return grade;
}

bool crashes(CheckResults const& results, Policy const& policy)
{
    return std::any_of(results.pictures.begin(), results.pictures.end(), [&](auto const& picture) {
        return picture.submitted && policy.ends.count(name_of(picture.submitted->ended)) > 0;
    });
}

bool applies(Policy const& policy, CheckResults const& results, Build const& build)
{
    return policy.id == "does_not_compile" ? !build.ok : crashes(results, policy);
}

void apply_policies(Grade& grade, CheckResults const& results, Build const& build, Rubric const& rubric)
{
    for (auto const& policy : rubric.policies) {
        if (!applies(policy, results, build))
            continue;
        grade.policies.push_back(policy.id);
        grade.earned = std::min(grade.earned, policy.points);
    }
}
}  // namespace

double round_half_up(double points, double step)
{
    constexpr double roundings_of_weights = 1e-9;
    return std::floor(points / step + 0.5 + roundings_of_weights) * step;
}

Grade score(CheckResults const& results, Build const& build, Rubric const& rubric, bool lenient)
{
    Grade grade;
    for (auto const& function : rubric.functions) {
        FunctionGrade const graded = grade_function(results, build, rubric, function);
        grade.functions.push_back(build.mended ? nothing_earned(build, function) : graded);
        bool const is_broken = !build.broken.empty() || !build.left_out.empty();
        if (is_broken && build.broken.count(function.function) == 0)
            grade.unofficial.push_back(graded);
        grade.earned += grade.functions.back().earned;
        grade.max += function.points;
    }
    grade.earned_without = grade.earned;
    if (!lenient)
        apply_policies(grade, results, build, rubric);
    grade.passed = grade.earned >= rubric.pass_fraction * grade.max;
    return grade;
}
}  // namespace testat
