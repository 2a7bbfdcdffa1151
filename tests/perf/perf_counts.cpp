// Work whose instructions ci/perf.sh counts, each piece by its name: what is done in `measured` counts, nothing else.
//
//   perf_counts --list | NAME
#include "bench/filters.h"
#include "bench/patterns.h"
#include "bench/scenes.h"
#include "checks/picture_rounds.h"
#include "checks/run_checks.h"
#include "installation.h"
#include "reference_answers.h"
#include "report/report.h"
#include "score/score.h"

#include <cglib/core/build_paths.h>
#include <cglib/rt/asset_library.h>
#include <cglib/rt/assignment_images.h>
#include <cglib/rt/prepared_render.h>
#include <cglib/rt/scenes.h>

#include <cstdio>
#include <map>

/// callgrind collects while this runs.
extern "C" __attribute__((noinline)) void measured(std::function<void()> const& work)
{
    work();
}

namespace testat {
namespace {
using Work = std::function<void()>;

// --- Lookup kernels
// ----------------------------------------------------------------------------------------------------

void look_up(bench::Filter const& filter)
{
    bench::View const view = bench::look_at(bench::scenes().front(), 64);
    bench::LookUp const kernel = filter.prepare(bench::make_texture(bench::patterns().front(), 256));
    bench::Colours colours(view.footprints.size());
    measured([&] { kernel(view.footprints.data(), view.footprints.size(), colours.data()); });
}

// --- The renderer
// ------------------------------------------------------------------------------------------------------

/// All that a picture takes once its scene is made, textures included.
void render(AssignmentImage const& picture)
{
    constexpr int side = 64;
    AssetLibrary assets(assets_directory());
    auto const scene = create_scene(picture.scene, assets);
    RaytracingParameters params = picture.params;
    params.width = params.height = side;
    Image image(side, side);
    measured([&] { PreparedRender(*scene, params).render({0, 0, side, side}, &image); });
}

// --- The judge
// ---------------------------------------------------------------------------------------------------------

/// What a right upload answers.
Observations right_answers(Request const& request)
{
    Observations observations;
    for (auto const& group : request.groups)
        observations.groups.emplace(group.name, reference_answers(group, request.textures));
    return observations;
}

void judge()
{
    Installation const& where = installation();
    Rubric const rubric = read_rubric(where.rubric);
    Build build;
    build.ok = true;
    build.defined = FunctionSet::all();
    build.library = "none";
    Questions const questions = make_questions(rubric, build.written(), 1);
    Observations const units = right_answers(questions.request);
    Observations const pictures = right_answers(ask_submitted(rubric, {}, build));
    measured([&] {
        CheckResults results = check(units, questions, rubric);
        judge_submitted(results, rubric, build, pictures, where);
        judge_isolated(results, {}, where);
        Grade const grade = score(results, build, rubric, false);
        to_text(make_report({}, build, results, grade, rubric, {}, {}, {}));
    });
}

std::map<std::string, Work> all_work()
{
    std::map<std::string, Work> all{{"judge", judge}};
    for (auto const& filter : bench::filters())
        all["lookup/" + filter.id] = [&] { look_up(filter); };
    for (auto const& picture : assignment_images())
        for (char const* name : {"plane_after_d", "sphere_after_f", "goboard_after_f", "pooltable_after_e"})
            if (picture.name == name)
                all["render/" + picture.name] = [&] { render(picture); };
    return all;
}
}  // namespace
}  // namespace testat

int main(int argc, char** argv)
{
    auto const all = testat::all_work();
    std::string const name = argc == 2 ? argv[1] : "";
    if (name == "--list") {
        for (auto const& [each, work] : all)
            std::puts(each.c_str());
        return 0;
    }
    auto const found = all.find(name);
    if (found == all.end()) {
        std::fprintf(stderr, "usage: perf_counts --list | NAME\n");
        return 2;
    }
    found->second();
    return 0;
}
