#include "stress/stress_report.h"
#include "text.h"

#include <algorithm>

namespace testat {
namespace {
Report number(double value)
{
    return std::isfinite(value) ? Report(value) : Report();
}

void put_counts(Report& to, Counts const& counts)
{
    to["nan"] = counts.nan;
    to["infinite"] = counts.infinite;
    to["crashed"] = counts.crashed;
    to["exceptions"] = counts.exceptions;
    to["timed_out"] = counts.timed_out;
    to["not_answered"] = counts.not_answered;
}

std::uint64_t count_wrong(std::vector<float> const& errors)
{
    return std::uint64_t(std::count_if(errors.begin(), errors.end(), [](float e) { return !(e <= 1); }));
}

Report function_to_json(FunctionStress const& result)
{
    Report function;
    function["written"] = result.written;
    function["asked"] = result.inside.counts.asked + result.outside.counts.asked;
    function["in_contract"] = result.inside.counts.asked;
    function["judged"] = result.inside.errors.size();
    function["undecided"] = result.inside.undecided;
    function["wrong"] = count_wrong(result.inside.errors);
    function["median"] = number(result.median);
    function["p999"] = number(result.p999);
    function["max"] = number(result.max);
    auto const& worst = result.inside.worst;
    function["worst_input"] = worst ? Report(worst->input) : Report();
    function["measured"] = worst ? Report(worst->measured) : Report();
    function["expected"] = worst ? Report(worst->expected) : Report();
    put_counts(function, result.inside.counts);
    function["outside"]["asked"] = result.outside.counts.asked;
    put_counts(function["outside"], result.outside.counts);
    return function;
}

Report diagnostics_to_json(Build const& build)
{
    Report all = Report::array();
    for (auto const& d : build.diagnostics)
        all.push_back({{"file", d.file},
                       {"line", d.line},
                       {"column", d.column},
                       {"severity", d.severity},
                       {"message", d.message}});
    return all;
}
}  // namespace

Report stress_to_json(Submission const& submission, Build const& build, StressOptions const& options,
                      std::vector<FunctionStress> const& results)
{
    Report document;
    document["schema_version"] = 1;
    document["file"] = submission.file;
    document["sha256"] = submission.sha256;
    document["seed"] = options.seed;
    document["build"] = {{"ok", build.ok}, {"compiler", build.compiler}, {"diagnostics", diagnostics_to_json(build)}};
    document["functions"] = Report::object();
    for (auto const& result : results)
        document["functions"][std::string(info(result.function).name)] = function_to_json(result);
    return document;
}
}  // namespace testat
