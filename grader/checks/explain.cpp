#include "checks/pictures.h"
#include "checks/run_checks.h"
#include "envelopes/pictures.h"

#include <algorithm>

namespace testat {
namespace {
bool needs_explaining(PictureResult const& picture)
{
    bool const wrong = picture.submitted_ended != Ended::answered || picture.submitted_outside > picture.limit;
    return picture.submitted_asked && wrong;
}

/// Functions that are not entirely right, in the order of the sheet.
std::vector<Function> suspects(CheckResults const& results)
{
    std::vector<Function> found;
    auto const add = [&](Function f) {
        if (std::find(found.begin(), found.end(), f) == found.end())
            found.push_back(f);
    };
    for (auto const& check : results.checks)
        if (!check.passed)
            add(check.function);
    for (auto const& picture : results.pictures)
        if (picture.score < 1)
            std::for_each(picture.functions.begin(), picture.functions.end(), add);
    std::sort(found.begin(), found.end());
    return found;
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

/// Whether a picture of repair_questions was made and is right.
bool is_right(PictureResult const& result, std::string const& from_upload, Observations const& observations,
              Envelope const& envelope)
{
    auto const found = observations.groups.find(group_name(result.name, from_upload));
    if (found == observations.groups.end())
        return false;
    auto const picture = read_picture(found->second);
    return picture && compare_picture(result.name, *picture, envelope).score == 1;
}

/// The suspects that spoil the picture, each by itself; all of them if it takes several together. Nobody if the
/// picture stays wrong without them.
std::vector<std::string> find_culprits(PictureResult const& result, std::vector<Function> const& suspected,
                                       Observations const& observations, Envelope const& envelope)
{
    if (!is_right(result, none, observations, envelope))
        return {};
    std::vector<std::string> all;
    std::vector<std::string> culprits;
    for (Function f : suspected) {
        all.emplace_back(info(f).name);
        if (!is_right(result, all.back(), observations, envelope))
            culprits.push_back(all.back());
    }
    return culprits.empty() ? all : culprits;
}
}  // namespace

Request repair_questions(CheckResults const& results)
{
    // Only words depend on these pictures, so they get little time.
    Request request{{2, 1, 10}, {}, {}};
    auto const functions = suspects(results);
    if (functions.empty())
        return request;
    FunctionSet const unsuspected = all_without(functions);
    for (auto const& picture : results.pictures) {
        if (!needs_explaining(picture))
            continue;
        add_group(picture.name, none, unsuspected, request);
        for (Function f : functions)
            if (functions.size() > 1)
                add_group(picture.name, std::string(info(f).name), unsuspected.with(f), request);
    }
    return request;
}

void explain(CheckResults& results, Observations const& repaired, Installation const& where)
{
    auto const functions = suspects(results);
    for (auto& picture : results.pictures)
        if (needs_explaining(picture))
            picture.explained_by = find_culprits(picture, functions, repaired,
                                                 read_envelope(where.envelopes / (picture.name + ".envelope")));
}
}  // namespace testat
