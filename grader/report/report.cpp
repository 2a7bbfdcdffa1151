#include "report/report.h"

#include "report/pictures.h"

#include <algorithm>
#include <cmath>

namespace testat {
namespace {
constexpr char const* verdict_names[] = {"correct", "partial", "wrong", "missing", "crashed", "timed_out"};

/// JSON knows neither NaN nor infinity.
Report number(double value)
{
    return std::isfinite(value) ? Report(value) : Report(nullptr);
}

Report phrase(Phrase const& text)
{
    return {{"de", text.de}, {"en", text.en}};
}

Report submission_part(Submission const& submission)
{
    return {{"file", submission.file}, {"sha256", submission.sha256}};
}

Report test_set_part(TestSet const& test_set)
{
    return {{"version", test_set.version}, {"sha256", test_set.sha256}, {"seed", test_set.seed}};
}

Report build_part(Build const& build)
{
    Report diagnostics = Report::array();
    for (auto const& d : build.diagnostics)
        diagnostics.push_back({{"file", d.file},
                               {"line", d.line},
                               {"column", d.column},
                               {"severity", d.severity},
                               {"message", d.message}});
    return {{"ok", build.ok}, {"compiler", build.compiler}, {"diagnostics", diagnostics}};
}

Report points_part(Grade const& grade)
{
    return {{"earned", grade.earned}, {"max", grade.max}, {"passed_60_percent", grade.passed}};
}

Report policy_part(Grade const& grade)
{
    return {{"applied", grade.policies}, {"earned_without", grade.earned_without}};
}

/// What went wrong, for a student: the rubric's hint for wrong values, the way it ended for everything else.
Report hint_part(RubricCheck const& check, CheckResult const& result)
{
    bool const values_are_wrong = !result.passed && result.ended == Ended::answered;
    if (!values_are_wrong)
        return result.trouble ? phrase(*result.trouble) : Report(nullptr);
    if (!result.trouble)
        return phrase(check.hint);
    return phrase({check.hint.de + " " + result.trouble->de, check.hint.en + " " + result.trouble->en});
}

Report worst_input_part(CheckResult const& result)
{
    if (!result.mismatch)
        return nullptr;
    return {{"input", result.mismatch->input}, {"measured", result.mismatch->measured}};
}

Report check_part(RubricCheck const& check, CheckResult const& result, ReportOptions const& options)
{
    return {{"name", check.name},
            {"visibility", check.is_public ? "public" : "hidden"},
            {"passed", result.passed},
            {"essential", check.essential},
            {"weight", check.weight},
            {"detail", options.for_tutor && !result.detail.empty() ? Report(result.detail) : Report(nullptr)},
            {"error", options.for_tutor && result.error ? number(*result.error) : Report(nullptr)},
            {"hint", hint_part(check, result)},
            {"worst_input", worst_input_part(result)}};
}

Report source_part(Build const& build, Function function)
{
    auto const found = build.sources.find(function);
    if (found == build.sources.end())
        return nullptr;
    return {{"line", found->second.line}, {"text", found->second.text}};
}

CheckResult const& result_of(CheckResults const& results, RubricCheck const& check)
{
    auto const found = std::find_if(results.checks.begin(), results.checks.end(),
                                    [&](auto const& result) { return result.name == check.name; });
    static CheckResult const none;
    return found == results.checks.end() ? none : *found;
}

/// What is said of the mistake that was recognised; null if none was, or the rubric has no words for it.
Report mistake_part(CheckResults const& results, RubricFunction const& function)
{
    auto const named = results.mistakes.find(function.function);
    if (named == results.mistakes.end())
        return nullptr;
    for (auto const& mistake : function.mistakes)
        if (mistake.id == named->second)
            return {{"id", mistake.id}, {"de", mistake.text.de}, {"en", mistake.text.en}};
    return nullptr;
}

Report function_part(RubricFunction const& function, FunctionGrade const& grade, Build const& build,
                     CheckResults const& results, ReportOptions const& options)
{
    Report checks = Report::array();
    for (auto const& check : function.checks)
        checks.push_back(check_part(check, result_of(results, check), options));
    Report part = {{"task", std::string(1, function.task)},
                   {"earned", grade.earned},
                   {"max", grade.max},
                   {"unit", grade.unit},
                   {"picture", grade.picture},
                   {"source", source_part(build, function.function)},
                   {"verdict", verdict_names[static_cast<int>(grade.verdict)]},
                   {"checks", checks}};
    if (Report mistake = mistake_part(results, function); !mistake.is_null())
        part["mistake"] = std::move(mistake);
    return part;
}

Report functions_part(Grade const& grade, Build const& build, CheckResults const& results, Rubric const& rubric,
                      ReportOptions const& options)
{
    Report functions = Report::object();
    for (std::size_t i = 0; i < rubric.functions.size(); ++i) {
        auto const& function = rubric.functions[i];
        functions[std::string(info(function.function).name)] =
            function_part(function, grade.functions[i], build, results, options);
    }
    return functions;
}

/// What the functions that compile would earn, and why the others do not.
Report unofficial_part(Grade const& grade, Build const& build)
{
    double earned = 0;
    double max = 0;
    Report functions = Report::object();
    for (auto const& function : grade.unofficial) {
        earned += function.earned;
        max += function.max;
        functions[std::string(info(function.function).name)] = {
            {"earned", function.earned},
            {"max", function.max},
            {"unit", function.unit},
            {"picture", function.picture},
            {"verdict", verdict_names[static_cast<int>(function.verdict)]}};
    }
    Report broken = Report::object();
    for (auto const& [function, error] : build.broken)
        broken[std::string(info(function).name)] = {{"line", error.line}, {"message", error.message}};
    Report part{{"earned", earned}, {"max", max}, {"functions", functions}, {"broken", broken}};
    for (auto const& error : build.left_out)
        part["left_out"].push_back({{"line", error.line}, {"message", error.message}});
    return part;
}

Report tasks_part(Grade const& grade, Rubric const& rubric)
{
    Report tasks = Report::array();
    for (auto const& task : rubric.tasks) {
        double earned = 0;
        double max = 0;
        for (std::size_t i = 0; i < rubric.functions.size(); ++i)
            if (rubric.functions[i].task == task.id) {
                earned += grade.functions[i].earned;
                max += grade.functions[i].max;
            }
        tasks.push_back(
            {{"id", std::string(1, task.id)}, {"title", phrase(task.title)}, {"earned", earned}, {"max", max}});
    }
    return tasks;
}

Report picture_part(PictureResult const& picture)
{
    Report functions = Report::array();
    for (auto const& isolated : picture.isolated)
        functions.push_back(info(isolated.function).name);
    auto const file = [&](PictureKind kind) {
        auto const path = picture_file(picture, kind);
        return path ? Report(*path) : Report(nullptr);
    };
    IsolatedPicture const* const isolated = worst(picture);
    auto const& shown = isolated != nullptr && isolated->rendering ? isolated->rendering : picture.submitted;
    Comparison const comparison = shown ? shown->comparison : Comparison{};
    Report part = {{"name", picture.name},
                   {"functions", functions},
                   {"outside", comparison.outside},
                   {"limit", comparison.limit},
                   {"score", isolated != nullptr ? isolated->score : comparison.score},
                   {"rms", number(comparison.rms)},
                   {"max_error", number(comparison.max_error)},
                   {"isolated_file", file(PictureKind::isolated)},
                   {"submitted_file", file(PictureKind::submitted)},
                   {"expected_file", file(PictureKind::expected)},
                   {"difference_file", file(PictureKind::difference)}};
    if (!picture.explained_by.empty())
        part["explained_by"] = picture.explained_by;
    return part;
}

Report pictures_part(CheckResults const& results)
{
    Report pictures = Report::array();
    for (auto const& picture : results.pictures)
        pictures.push_back(picture_part(picture));
    return pictures;
}

Report remarks_part(CheckResults const& results)
{
    Report remarks = Report::array();
    for (auto const& remark : results.remarks) {
        Report functions = Report::array();
        for (Function f : remark.functions)
            functions.push_back(info(f).name);
        remarks.push_back(
            {{"id", remark.id}, {"functions", functions}, {"de", remark.text.de}, {"en", remark.text.en}});
    }
    return remarks;
}

Report run_time_part(CheckResults const& results)
{
    Report times = Report::array();
    for (auto const& picture : results.pictures)
        if (picture.submitted && picture.submitted->picture)
            times.push_back({{"picture", picture.name}, {"ms", picture.ms}, {"reference_ms", picture.reference_ms}});
    return times;
}

Report timing_part(Timing const& timing)
{
    return {{"compile_ms", timing.compile_ms},
            {"observe_ms", timing.observe_ms},
            {"check_ms", timing.check_ms},
            {"total_ms", timing.total_ms}};
}
}  // namespace

Report make_report(Submission const& submission, Build const& build, CheckResults const& results, Grade const& grade,
                   Rubric const& rubric, TestSet const& test_set, Timing const& timing, ReportOptions const& options)
{
    Report report = {{"schema_version", 1},
                     {"status", "graded"},
                     {"submission", submission_part(submission)},
                     {"test_set", test_set_part(test_set)},
                     {"sandbox", options.sandbox},
                     {"build", build_part(build)},
                     {"points", points_part(grade)},
                     {"policy", policy_part(grade)},
                     {"functions", functions_part(grade, build, results, rubric, options)},
                     {"tasks", tasks_part(grade, rubric)},
                     {"pictures", pictures_part(results)},
                     {"run_time", run_time_part(results)},
                     {"timing", timing_part(timing)}};
    if (!grade.unofficial.empty())
        report["unofficial"] = unofficial_part(grade, build);
    if (!results.remarks.empty())
        report["remarks"] = remarks_part(results);
    return report;
}

Report make_not_gradable(Submission const& submission, TestSet const& test_set, std::string const& error)
{
    return {{"schema_version", 1},
            {"status", "not_gradable"},
            {"error", error},
            {"submission", submission_part(submission)},
            {"test_set", test_set_part(test_set)}};
}

std::string to_text(Report const& report)
{
    return report.dump(2, ' ', false, Report::error_handler_t::replace) + "\n";
}
}  // namespace testat
