#include "bench/bench_report.h"
#include "bench/patterns.h"
#include "bench/truth.h"

#include <algorithm>
#include <cmath>

namespace testat::bench {
namespace {
Report number(double value)
{
    return std::isfinite(value) ? Report(value) : Report();
}

Report scores_to_json(std::map<std::string, Score> const& scores, std::vector<Named> const& filters)
{
    Report all = Report::object();
    for (auto const& filter : filters)
        if (auto const found = scores.find(filter.id); found != scores.end()) {
            Score const& s = found->second;
            all[filter.id] = {
                {"ns", s.ns > 0 ? number(s.ns) : Report()}, {"rmse", number(s.rmse)}, {"delta_e", number(s.delta_e)}};
        }
    return all;
}

Report summary_to_json(BenchResults const& results, std::string const& pattern)
{
    auto const scores = mean_scores(results, pattern);
    return {{"filters", scores_to_json(scores, results.filters)}, {"pareto", pareto_front(scores)}};
}

char const* name_of(Family family)
{
    switch (family) {
        case Family::reference:
            return "reference";
        case Family::fast:
            return "fast";
        case Family::beyond:
            return "beyond";
        default:
            return "upload";
    }
}

Report filters_to_json(std::vector<Named> const& filters)
{
    Report all = Report::array();
    for (auto const& filter : filters)
        all.push_back({{"id", filter.id},
                       {"family", name_of(filter.family)},
                       {"title", {{"de", filter.title.de}, {"en", filter.title.en}}}});
    return all;
}

Report ratios_to_json(Ratios const& r)
{
    return {{"trilinear_speed_up", number(r.trilinear_speed_up)},
            {"trilinear_error", number(r.trilinear_error)},
            {"anisotropic_4_error", number(r.anisotropic_error)},
            {"anisotropic_4_worst_error", number(r.worst_anisotropic_error)},
            {"anisotropic_4_time", number(r.anisotropic_time)}};
}

Report upload_to_json(Submission const* submission, Build const* build)
{
    if (submission == nullptr || build == nullptr)
        return nullptr;
    Report diagnostics = Report::array();
    for (auto const& d : build->diagnostics)
        diagnostics.push_back({{"file", d.file},
                               {"line", d.line},
                               {"column", d.column},
                               {"severity", d.severity},
                               {"message", d.message}});
    return {{"file", submission->file},
            {"sha256", submission->sha256},
            {"build", {{"ok", build->ok}, {"compiler", build->compiler}, {"diagnostics", diagnostics}}}};
}
}  // namespace

Report bench_to_json(BenchResults const& results, Submission const* submission, Build const* build)
{
    Report document;
    document["schema_version"] = 1;
    document["upload"] = upload_to_json(submission, build);
    document["picture_side"] = results.picture_side;
    document["rounds"] = results.rounds;
    document["samples"] = least_strata * least_strata;
    document["filters"] = filters_to_json(results.filters);
    document["ratios"] = ratios_to_json(ratios(results));
    document["summary"]["all"] = summary_to_json(results, "");
    for (auto const& pattern : patterns())
        document["summary"][pattern.id] = summary_to_json(results, pattern.id);
    document["float_errors"] = Report::object();
    for (auto const& filter : results.filters)
        if (auto const found = results.float_errors.find(filter.id); found != results.float_errors.end())
            for (double error : found->second)
                document["float_errors"][filter.id].push_back(number(error));
    document["cases"] = Report::array();
    for (auto const& one : results.cases)
        document["cases"].push_back({{"scene", one.scene},
                                     {"texture", one.pattern},
                                     {"texture_side", one.texture_side},
                                     {"pixels", one.pixels},
                                     {"filters", scores_to_json(one.scores, results.filters)}});
    return document;
}
}  // namespace testat::bench
