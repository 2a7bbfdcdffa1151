#include "checks/check.h"
#include "checks/picture_rounds.h"
#include "checks/remarks.h"
#include "checks/run_checks.h"
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
    group.fill = usual_fill;
    group.from_upload = FunctionSet::only(check.function);
    return group;
}

std::string hash(Request const& request)
{
    auto const bytes = serialize(request);
    return sha256({reinterpret_cast<char const*>(bytes.data()), bytes.size()});
}

Request unit_questions(Rubric const& rubric, FunctionSet available, std::uint64_t seed, std::string const& upload)
{
    Request request{rubric.limits, FunctionSet(), make_test_textures(seed, upload), {}};
    for (auto const& function : rubric.functions) {
        if (!available.has(function.function))
            continue;
        for (auto const& check : function.checks)
            request.groups.push_back(unit_group(find_check(check.name), seed, request.textures));
    }
    return request;
}
}  // namespace

Questions make_questions(Rubric const& rubric, FunctionSet available, std::uint64_t seed,
                         std::string const& upload_sha256)
{
    // The test set's name must not depend on what an upload lacks, and which pictures are made on what it does. What
    // depends on the upload's bytes is taken as an upload with no hash at all would be asked.
    Request everything = unit_questions(rubric, FunctionSet::all(), seed, "");
    for (auto const& [picture, functions] : pictures_of(rubric))
        everything.groups.push_back(submitted_group(picture, true));
    return {unit_questions(rubric, available, seed, upload_sha256), seed, hash(everything)};
}
}  // namespace testat
