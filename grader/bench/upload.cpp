#include "bench/upload.h"

#include "bench/float_error.h"
#include "observe/observe.h"

#include <algorithm>
#include <cstring>

namespace testat::bench {
namespace {
/// CPU seconds. A hundred times as long as the solution is no use in a picture.
constexpr Limits limits{10, 1, 60, 3, 600, 600};
constexpr Limits trial_limits{1, 1, 10, 3, 20, 60};
constexpr std::size_t trial_questions = 64;

/// What takes part in a lookup.
FunctionSet lookup_functions()
{
    FunctionSet functions;
    for (Function f : {Function::evaluate_nearest, Function::wrap_clamp, Function::wrap_repeat,
                       Function::evaluate_bilinear, Function::evaluate_trilinear})
        functions = functions.with(f);
    return functions;
}

/// All that the upload has written of these: its own functions call each other.
FunctionSet taken_from(Build const& build)
{
    return FunctionSet(lookup_functions().bits() & build.written().bits());
}

bool can_be_asked(UploadFilter const& filter, Build const& build)
{
    return !build.library.empty() && (!filter.is_upload || build.written().has(filter.function));
}

Group questions_about(Footprints const& footprints)
{
    std::vector<LookupQuestion> questions;
    questions.reserve(footprints.size());
    for (auto const& f : footprints)
        questions.push_back({0, 0, {f.uv.x, f.uv.y}, {f.dudv.x, f.dudv.y}});
    return make_group(Kind::lookup, questions);
}

void put(Request& request, UploadFilter const& filter, Group group, Build const& build)
{
    group.name = filter.id;
    group.under_test = filter.function;
    group.from_upload = filter.is_upload ? taken_from(build) : FunctionSet();
    request.groups.push_back(std::move(group));
}

bool is_answered(Observations const& observations, UploadFilter const& filter)
{
    Answers const* answers = observations.find(filter.id);
    return answers != nullptr && answers->status.ended == Ended::answered;
}

Measured measured(Answers const& answers)
{
    Measured result{answers.status.pass_s, Colours(answers.group.count)};
    std::memcpy(result.colours.data(), answers.words.data(), 4 * answers.words.size());
    return result;
}
}  // namespace

std::vector<UploadFilter> const& upload_filters()
{
    static std::vector<UploadFilter> const all = {
        {"upload_nearest", {"nearest, Abgabe", "nearest, upload"}, Function::evaluate_nearest, true},
        {"caged_nearest",
         {"nearest, Referenz im Käfig", "nearest, caged reference"},
         Function::evaluate_nearest,
         false},
        {"upload_bilinear", {"bilinear, Abgabe", "bilinear, upload"}, Function::evaluate_bilinear, true},
        {"caged_bilinear",
         {"bilinear, Referenz im Käfig", "bilinear, caged reference"},
         Function::evaluate_bilinear,
         false},
        {"upload_trilinear", {"trilinear, Abgabe", "trilinear, upload"}, Function::evaluate_trilinear, true},
        {"caged_trilinear",
         {"trilinear, Referenz im Käfig", "trilinear, caged reference"},
         Function::evaluate_trilinear,
         false},
    };
    return all;
}

FilterIds answering_filters(Build const& build, TextureData const& texture, Footprints const& footprints,
                            Installation const& where, Cage& cage)
{
    Request request;
    request.limits = trial_limits;
    request.textures = {texture};
    Footprints const few(footprints.begin(),
                         footprints.begin() + std::ptrdiff_t(std::min(trial_questions, footprints.size())));
    for (auto const& filter : upload_filters())
        if (can_be_asked(filter, build))
            put(request, filter, questions_about(few), build);
    FilterIds answering;
    if (request.groups.empty())
        return answering;
    Observations const observations = observe(build, request, where, cage);
    for (auto const& filter : upload_filters())
        if (is_answered(observations, filter))
            answering.insert(filter.id);
    return answering;
}

std::map<std::string, Measured> measure_upload(Build const& build, FilterIds const& asked, TextureData const& texture,
                                               Footprints const& footprints, int rounds, Installation const& where,
                                               Cage& cage)
{
    Request request;
    request.limits = limits;
    request.textures = {texture};
    for (auto const& filter : upload_filters())
        if (asked.count(filter.id) > 0) {
            put(request, filter, questions_about(footprints), build);
            request.groups.back().passes = static_cast<std::uint32_t>(rounds);
        }
    std::map<std::string, Measured> results;
    if (request.groups.empty())
        return results;
    Observations const observations = observe(build, request, where, cage);
    for (auto const& filter : upload_filters())
        if (is_answered(observations, filter))
            results.emplace(filter.id, measured(observations.groups.at(filter.id)));
    return results;
}

std::map<std::string, std::vector<double>> float_errors_of_upload(Build const& build, FilterIds const& asked,
                                                                  Installation const& where, Cage& cage)
{
    std::map<std::string, std::vector<double>> errors;
    for (auto const& filter : upload_filters()) {
        if (!filter.is_upload || filter.function == Function::evaluate_nearest || asked.count(filter.id) == 0)
            continue;
        for (int decade = 0; decade < decades; ++decade) {
            FarLookups far = far_lookups(filter.function, decade);
            Request request;
            request.limits = limits;
            request.textures = far.textures;
            put(request, filter, std::move(far.group), build);
            Observations const observations = observe(build, request, where, cage);
            errors[filter.id].push_back(worst_error(observations.groups.at(filter.id), far.textures));
        }
    }
    return errors;
}
}  // namespace testat::bench
