#include "checks/picture_rounds.h"
#include "checks/pictures.h"
#include "envelopes/pictures.h"

#include <algorithm>

namespace testat {
namespace {
bool needs_explaining(PictureResult const& picture)
{
    return picture.submitted && picture.submitted->comparison.score < 1;
}

/// Functions that are not entirely right and may have a hand in the picture, in the order of the sheet. What passes its
/// unit checks and fails another picture has no part in this one if it is right without those that fail unit checks.
std::vector<Function> suspects(CheckResults const& results, PictureResult const& picture)
{
    FunctionSet right = results.passing();
    for (auto const& other : results.pictures)
        for (auto const& isolated : other.isolated)
            if (isolated.score < 1 && !is_right(picture.without_suspects))
                right = right.without(isolated.function);
    std::vector<Function> found;
    for (Function f : every_function())
        if (!right.has(f) && functions_in(picture.name).has(f))
            found.push_back(f);
    return found;
}

/// Whether the picture is right with this function alone from the upload: where that was made, or need not be.
std::optional<bool> known_alone(PictureResult const& result, Function function, FunctionSet written)
{
    if (!written.has(function))
        return !called_in(result.name).has(function);
    for (auto const& isolated : result.isolated)
        if (isolated.function == function && isolated.rendering)
            return isolated.score == 1;
    return std::nullopt;
}

constexpr char none[] = "none";

/// The picture with this suspect, or none, from the upload and the other suspects from the reference.
std::string group_name(std::string const& picture, std::string const& suspect)
{
    return "repaired/" + picture + "/" + suspect;
}

void add_group(std::string const& picture, std::string const& suspect, FunctionSet from_upload, Request& request)
{
    Group group = picture_group(picture);
    group.name = group_name(picture, suspect);
    group.from_upload = from_upload;
    request.groups.push_back(std::move(group));
}

FunctionSet all_without(std::vector<Function> const& functions)
{
    FunctionSet rest = FunctionSet::all();
    for (Function f : functions)
        rest = rest.without(f);
    return rest;
}

/// Whether a picture of ask_repaired was made and is right.
bool is_right(PictureResult const& result, std::string const& from_upload, Observations const& observations,
              Envelope const& envelope)
{
    auto const* answers = observations.find(group_name(result.name, from_upload));
    auto const picture = answers == nullptr ? std::nullopt : read_picture(*answers);
    return picture && compare_picture(result.name, *picture, envelope).score == 1;
}

/// Whether nothing of the upload is left in the picture without its suspects.
bool are_all(std::vector<Function> const& suspected, std::string const& picture)
{
    return !functions_in(picture).meets(all_without(suspected));
}

/// Whether it need not be asked what the picture looks like without its suspects.
bool is_known_without(std::vector<Function> const& suspected, PictureResult const& picture, CheckResults const& results)
{
    auto const has_failed = [&](Function f) { return !results.passing().has(f); };
    return are_all(suspected, picture.name) ||
           (picture.without_suspects && std::all_of(suspected.begin(), suspected.end(), has_failed));
}

bool is_right_without(std::vector<Function> const& suspected, PictureResult const& result,
                      Observations const& observations, Envelope const& envelope)
{
    return are_all(suspected, result.name) || is_right(result.without_suspects) ||
           is_right(result, none, observations, envelope);
}

/// The suspects that spoil the picture, each by itself; all of them if it takes several together. Nobody if the
/// picture stays wrong without them.
std::vector<std::string> find_culprits(PictureResult const& result, std::vector<Function> const& suspected,
                                       FunctionSet written, Observations const& observations, Envelope const& envelope)
{
    if (!is_right_without(suspected, result, observations, envelope))
        return {};
    std::vector<std::string> all;
    std::vector<std::string> culprits;
    for (Function f : suspected) {
        all.emplace_back(info(f).name);
        auto const alone = known_alone(result, f, written);
        if (!(alone ? *alone : is_right(result, all.back(), observations, envelope)))
            culprits.push_back(all.back());
    }
    return culprits.empty() ? all : culprits;
}
}  // namespace

Request ask_repaired(CheckResults const& results, FunctionSet written)
{
    // Only words depend on these pictures, so they get little time.
    Request request{{2, 1, 10}, FunctionSet(), {}, {}};
    for (auto const& picture : results.pictures) {
        auto const suspected = suspects(results, picture);
        if (!needs_explaining(picture) || suspected.empty())
            continue;
        FunctionSet const unsuspected = all_without(suspected);
        if (!is_known_without(suspected, picture, results))
            add_group(picture.name, none, unsuspected, request);
        for (Function f : suspected)
            if (suspected.size() > 1 && !known_alone(picture, f, written))
                add_group(picture.name, std::string(info(f).name), unsuspected.with(f), request);
    }
    return request;
}

FunctionSet unexplained(CheckResults const& results, FunctionSet written, Observations const& repaired,
                        Installation const& where)
{
    FunctionSet found;
    for (auto const& picture : results.pictures) {
        auto const suspected = suspects(results, picture);
        if (needs_explaining(picture) &&
            !is_right_without(suspected, picture, repaired,
                              read_envelope(where.envelopes / (picture.name + ".envelope"))))
            found = found | (functions_in(picture.name) & all_without(suspected));
    }
    return found & written;
}

void explain(CheckResults& results, FunctionSet written, Observations const& repaired, Installation const& where)
{
    for (auto& picture : results.pictures)
        if (needs_explaining(picture))
            picture.explained_by = find_culprits(picture, suspects(results, picture), written, repaired,
                                                 read_envelope(where.envelopes / (picture.name + ".envelope")));
}
}  // namespace testat
