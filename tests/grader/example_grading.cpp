#include "example_grading.h"

#include "grey_picture.h"

#include <stdexcept>

namespace testat {
namespace {
RubricCheck check(std::string const& name, double weight, bool essential)
{
    return {name, weight, essential, true, {"Titel", "title"}, {"Hinweis zu " + name, "hint for " + name}};
}

Rendering right_rendering(Picture const& picture)
{
    Rendering rendering;
    rendering.ended = Ended::answered;
    rendering.picture = picture;
    rendering.comparison.score = 1;
    return rendering;
}

RubricFunction function(Function f, std::vector<std::string> const& pictures, std::vector<RubricCheck> const& checks)
{
    RubricFunction result;
    result.function = f;
    result.task = 'b';
    result.points = 1;
    result.pictures = pictures;
    result.checks = checks;
    return result;
}
}  // namespace

Rubric example_rubric()
{
    Rubric rubric;
    rubric.tasks = {{'b', {"Umgang mit Rändern", "Wrapping"}}};
    rubric.functions = {function(Function::wrap_clamp, {"clamped"},
                                 {check("WrapClamp.Inside", 0.25, true), check("WrapClamp.Negative", 0.75, false)}),
                        function(Function::wrap_repeat, {}, {check("WrapRepeat.Inside", 1, true)})};
    rubric.policies = {{"does_not_compile", 0, {}, {"de", "en"}}, {"crashes", 0.5, {"signal", "exit"}, {"de", "en"}}};
    return rubric;
}

CheckResults passed_results(Rubric const& rubric)
{
    CheckResults results;
    for (auto const& f : rubric.functions) {
        for (auto const& c : f.checks) {
            CheckResult result;
            result.name = c.name;
            result.function = f.function;
            result.passed = true;
            results.checks.push_back(result);
        }
    }
    for (auto const& [name, functions] : pictures_of(rubric)) {
        PictureResult picture;
        picture.name = name;
        picture.expected = grey_picture(2, 2, 0.5f);
        picture.submitted = right_rendering(picture.expected);
        for (Function f : functions)
            picture.isolated.push_back({f, picture.submitted, 1});
        results.pictures.push_back(picture);
    }
    return results;
}

Build whole_build()
{
    Build build;
    build.ok = true;
    build.compiler = "g++ 13";
    build.library = "upload.so";
    build.defined = FunctionSet::all();
    return build;
}

Build mended_build()
{
    Build build = whole_build();
    build.ok = false;
    build.mended = true;
    build.broken[Function::wrap_clamp] = {"exercise_03.cpp", 3, 1, "error", "'x' was not declared"};
    build.diagnostics = {build.broken[Function::wrap_clamp]};
    build.defined = FunctionSet::all().without(Function::wrap_clamp);
    build.sources[Function::wrap_clamp] = {2, "int wrap_clamp() { x }"};
    return build;
}

CheckResult& find_result(CheckResults& results, std::string const& name)
{
    for (auto& result : results.checks)
        if (result.name == name)
            return result;
    throw std::runtime_error("no result " + name);
}
}  // namespace testat
