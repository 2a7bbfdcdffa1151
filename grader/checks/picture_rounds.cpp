#include "checks/picture_rounds.h"

#include "checks/pictures.h"
#include "envelopes/pictures.h"

#include <algorithm>

namespace testat {
namespace {
constexpr char check_without_transforms[] = "Intersect.TransformsOff";

bool passes(CheckResults const& results, std::string const& name)
{
    return std::any_of(results.checks.begin(), results.checks.end(),
                       [&](auto const& check) { return check.name == name && check.passed; });
}

/// Objects that a ray cannot meet may be left out only if the functions that find hits are right: or their mistakes
/// would not show. `from_upload`: of those that are written.
bool may_cull(CheckResults const& results, FunctionSet from_upload, std::string const& picture)
{
    if (!is_transformed(picture))
        return !from_upload.has(Function::intersect) || passes(results, check_without_transforms);
    for (Function f : {Function::transform_direction, Function::transform_position, Function::intersect})
        if (from_upload.has(f) && !results.all_pass(f))
            return false;
    return true;
}

FunctionSet hanging(CheckResults const& results)
{
    FunctionSet found;
    for (auto const& check : results.checks)
        if (check.ended == Ended::timed_out)
            found = found.with(check.function);
    return found;
}

std::string isolated_name(std::string const& picture, Function function)
{
    return "isolated/" + picture + "/" + std::string(info(function).name);
}

bool is_right(std::optional<Rendering> const& rendering)
{
    return rendering && rendering->comparison.score == 1;
}

bool must_be_isolated(PictureResult const& picture, CheckResults const& results, Function function)
{
    return !is_right(picture.submitted) || !results.all_pass(function);
}

Group isolated_group(CheckResults const& results, std::string const& picture, Function function)
{
    Group group = picture_group(picture);
    group.name = isolated_name(picture, function);
    group.from_upload = FunctionSet::only(function);
    group.culling = may_cull(results, group.from_upload, picture);
    return group;
}

Envelope envelope_of(std::string const& picture, Installation const& where)
{
    return read_envelope(where.envelopes / (picture + ".envelope"));
}
}  // namespace

Group submitted_group(std::string const& picture, bool culling)
{
    Group group = picture_group(picture);
    group.name = "submitted/" + picture;
    group.from_upload = FunctionSet::all();
    group.culling = culling;
    return group;
}

Request ask_submitted(Rubric const& rubric, CheckResults const& results, Build const& build)
{
    Request request{rubric.limits, hanging(results), {}, {}};
    if (build.ok)
        for (auto const& [picture, functions] : pictures_of(rubric))
            request.groups.push_back(submitted_group(picture, may_cull(results, build.written(), picture)));
    return request;
}

void judge_submitted(CheckResults& results, Rubric const& rubric, Build const& build, Observations const& observations,
                     Installation const& where)
{
    for (auto const& [name, functions] : pictures_of(rubric)) {
        Envelope const envelope = envelope_of(name, where);
        PictureResult result;
        result.name = name;
        result.expected = envelope.expected;
        result.reference_ms = envelope.reference_ms;
        for (Function f : functions)
            result.isolated.push_back({f, std::nullopt, 1});
        std::string const group = "submitted/" + name;
        if (build.ok)
            result.submitted = judge_rendering(name, group, observations, envelope);
        auto const* answers = observations.find(group);
        result.ms = answers == nullptr ? 0 : 1e3 * answers->status.work_s;
        results.pictures.push_back(std::move(result));
    }
}

Request ask_isolated(Rubric const& rubric, CheckResults const& results, Build const& build)
{
    Request request{rubric.limits, hanging(results), {}, {}};
    for (auto const& picture : results.pictures)
        for (auto const& isolated : picture.isolated)
            if (build.written().has(isolated.function) && must_be_isolated(picture, results, isolated.function))
                request.groups.push_back(isolated_group(results, picture.name, isolated.function));
    return request;
}

void judge_isolated(CheckResults& results, Observations const& observations, Installation const& where)
{
    for (auto& picture : results.pictures)
        for (auto& isolated : picture.isolated) {
            if (!must_be_isolated(picture, results, isolated.function))
                continue;
            isolated.rendering = judge_rendering(picture.name, isolated_name(picture.name, isolated.function),
                                                 observations, envelope_of(picture.name, where));
            isolated.score = isolated.rendering->comparison.score;
        }
}
}  // namespace testat
