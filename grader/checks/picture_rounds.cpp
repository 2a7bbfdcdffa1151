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
    FunctionSet const find_hits =
        FunctionSet::only(Function::transform_direction).with(Function::transform_position).with(Function::intersect);
    return (from_upload & find_hits).is_subset_of(results.passing());
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

std::string name_without_suspects(std::string const& picture)
{
    return "without_suspects/" + picture;
}

/// Whether the picture may show whose fault it is that it is wrong as submitted: functions of both kinds have a hand in
/// it.
bool must_be_made_without_suspects(PictureResult const& picture, CheckResults const& results)
{
    FunctionSet const in_picture = functions_in(picture.name);
    FunctionSet const passing = results.passing();
    return !is_right(picture.submitted) && !picture.without_suspects && in_picture.meets(passing) &&
           !in_picture.is_subset_of(passing);
}

/// Without its suspects a picture tells of all other functions at once.
bool must_be_isolated(PictureResult const& picture, CheckResults const& results, IsolatedPicture const& isolated)
{
    if (isolated.rendering)
        return false;
    if (!results.passing().has(isolated.function))
        return true;
    return !is_right(picture.submitted) && !must_be_made_without_suspects(picture, results);
}

Group culled_group(CheckResults const& results, std::string const& picture, std::string name, FunctionSet from_upload)
{
    Group group = picture_group(picture);
    group.name = std::move(name);
    group.from_upload = from_upload;
    group.culling = may_cull(results, from_upload, picture);
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
    FunctionSet const written = build.written();
    for (auto const& picture : results.pictures) {
        if (must_be_made_without_suspects(picture, results))
            request.groups.push_back(
                culled_group(results, picture.name, name_without_suspects(picture.name), results.passing() & written));
        for (auto const& isolated : picture.isolated)
            if (written.has(isolated.function) && must_be_isolated(picture, results, isolated))
                request.groups.push_back(culled_group(results, picture.name,
                                                      isolated_name(picture.name, isolated.function),
                                                      FunctionSet::only(isolated.function)));
    }
    return request;
}

void judge_isolated(CheckResults& results, Observations const& observations, Installation const& where)
{
    for (auto& picture : results.pictures) {
        auto const judge = [&](std::string const& group) {
            return judge_rendering(picture.name, group, observations, envelope_of(picture.name, where));
        };
        for (auto& isolated : picture.isolated)
            if (must_be_isolated(picture, results, isolated)) {
                isolated.rendering = judge(isolated_name(picture.name, isolated.function));
                isolated.score = isolated.rendering->comparison.score;
            }
        if (must_be_made_without_suspects(picture, results))
            picture.without_suspects = judge(name_without_suspects(picture.name));
        if (is_right(picture.without_suspects))
            for (auto& isolated : picture.isolated)
                if (!isolated.rendering)
                    isolated.rendering = picture.without_suspects;
    }
}
}  // namespace testat
