#include "checks/check.h"
#include "checks/run_checks.h"
#include "envelopes/pictures.h"
#include "text.h"

#include <algorithm>
#include <stdexcept>

namespace testat {
namespace {
UnitCheck const& find_check(std::string const& name)
{
    auto const& all = unit_checks();
    auto const found = std::find_if(all.begin(), all.end(), [&](auto const& check) { return check.name == name; });
    if (found == all.end())
        throw BadRubric("rubric: there is no unit check " + name);
    return *found;
}

Group unit_group(UnitCheck const& check, std::uint64_t seed, Textures const& textures)
{
    Random random(seed, check.name);
    Group group = check.ask(random, textures);
    group.name = check.name;
    group.under_test = check.function;
    group.from_upload = FunctionSet::only(check.function);
    return group;
}

void add_picture(std::string const& name, std::string const& picture, FunctionSet from_upload, Request& request)
{
    Group group = picture_group(picture);
    group.name = name;
    group.from_upload = from_upload;
    request.groups.push_back(std::move(group));
}

std::string hash(Request const& request)
{
    auto const bytes = serialize(request);
    return sha256({reinterpret_cast<char const*>(bytes.data()), bytes.size()});
}

Request isolated_questions(Rubric const& rubric, FunctionSet available, std::uint64_t seed)
{
    Request request{rubric.limits, make_test_textures(seed), {}};
    for (auto const& function : rubric.functions) {
        if (!available.has(function.function))
            continue;
        for (auto const& check : function.checks)
            request.groups.push_back(unit_group(find_check(check.name), seed, request.textures));
        for (auto const& picture : function.pictures)
            add_picture("isolated/" + picture, picture, FunctionSet::only(function.function), request);
    }
    return request;
}
}  // namespace

Questions make_questions(Rubric const& rubric, FunctionSet available, bool as_submitted, std::uint64_t seed)
{
    // The test set's name must not depend on what an upload lacks.
    std::string const name = hash(isolated_questions(rubric, FunctionSet::all(), seed));
    Questions questions{isolated_questions(rubric, available, seed), seed, name};
    if (as_submitted)
        for (auto const& [picture, functions] : pictures_of(rubric))
            add_picture("submitted/" + picture, picture, FunctionSet::all(), questions.request);
    return questions;
}
}  // namespace testat
