#include "bench/upload.h"

#include "bench/float_error.h"
#include "observe/observe.h"

#include <fmt/format.h>

#include <cstring>

namespace testat::bench {
namespace {
/// CPU seconds: a lookup that takes a thousand times as long as it should is no use in a picture.
constexpr Limits limits{5, 1, 60, 10, 600, 600};

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

std::string name_of(UploadFilter const& filter, std::size_t number)
{
    return fmt::format("bench/{}/{}", filter.id, number);
}

void put(Request& request, UploadFilter const& filter, std::size_t number, Group group, Build const& build)
{
    group.name = name_of(filter, number);
    group.under_test = filter.function;
    group.from_upload = filter.is_upload ? taken_from(build) : FunctionSet();
    request.groups.push_back(std::move(group));
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

std::vector<UploadMeasured> measure_upload(Build const& build, TextureData const& texture,
                                           std::vector<Footprints const*> const& views, int rounds,
                                           Installation const& where, Cage& cage)
{
    Request request;
    request.limits = limits;
    request.textures = {texture};
    for (std::size_t view = 0; view < views.size(); ++view)
        for (auto const& filter : upload_filters())
            if (can_be_asked(filter, build)) {
                put(request, filter, view, questions_about(*views[view]), build);
                request.groups.back().passes = static_cast<std::uint32_t>(rounds);
            }
    std::vector<UploadMeasured> results(views.size());
    if (request.groups.empty())
        return results;
    Observations const observations = observe(build, request, where, cage);
    for (std::size_t view = 0; view < views.size(); ++view)
        for (auto const& filter : upload_filters())
            if (Answers const* answers = observations.find(name_of(filter, view));
                answers != nullptr && answers->status.ended == Ended::answered)
                results[view].emplace(filter.id, measured(*answers));
    return results;
}

std::map<std::string, std::vector<double>> float_errors_of_upload(Build const& build, Installation const& where,
                                                                  Cage& cage)
{
    std::map<std::string, std::vector<double>> errors;
    for (auto const& filter : upload_filters()) {
        if (!filter.is_upload || filter.function == Function::evaluate_nearest || !can_be_asked(filter, build))
            continue;
        for (int decade = 0; decade < decades; ++decade) {
            FarLookups far = far_lookups(filter.function, decade);
            Request request;
            request.limits = limits;
            request.textures = far.textures;
            put(request, filter, 0, std::move(far.group), build);
            Observations const observations = observe(build, request, where, cage);
            errors[filter.id].push_back(worst_error(observations.groups.at(name_of(filter, 0)), far.textures));
        }
    }
    return errors;
}
}  // namespace testat::bench
