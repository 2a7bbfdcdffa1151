#include "grade.h"

#include "checks/circular.h"
#include "checks/picture_rounds.h"
#include "checks/remarks.h"
#include "checks/run_checks.h"
#include "observe/observe.h"
#include "process/run.h"
#include "report/pictures.h"
#include "score/score.h"

#include <unistd.h>

#include <chrono>
#include <fstream>

namespace testat {
namespace {
Rubric select(Rubric rubric, GradeOptions const& options)
{
    if (!options.tasks.empty())
        rubric = only_tasks(std::move(rubric), options.tasks);
    return options.for_tutor ? rubric : only_public(std::move(rubric));
}

/// Starts no probe where there is nothing to run, or nothing to ask. `ms` adds up what observing takes.
Observations observe_if_any(Build const& build, Request const& request, Installation const& where, Cage& cage,
                            double& ms)
{
    if (build.library.empty() || request.groups.empty())
        return {};
    Observations observations = observe(build, request, where, cage);
    ms += observations.ms;
    return observations;
}

using Time = std::chrono::steady_clock::time_point;

double ms_since(Time start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The pipeline.
Report run_pipeline(Submission const& submission, Rubric const& rubric, GradeOptions const& options,
                    Installation const& where)
{
    auto const start = std::chrono::steady_clock::now();
    Cage cage(options.confinement);
    TemporaryDirectory const workplace;
    Build const build =
        compile(submission, {options.compiler, rubric.standard, options.compiler_flags}, workplace.path(), where, cage);
    double const compiled_ms = ms_since(start);
    Questions const questions = make_questions(rubric, build.written(), options.seed, submission.sha256);
    double observe_ms = 0;
    auto const answers = [&](Request const& request) {
        return observe_if_any(build, request, where, cage, observe_ms);
    };

    Observations const units = answers(questions.request);
    CheckResults results = check(units, questions, rubric);
    Request submitted = ask_submitted(rubric, results, build);
    ask_again(submitted, units, questions.request.textures);
    Observations const again = answers(submitted);
    judge_submitted(results, rubric, build, again, where);
    Request isolated = ask_isolated(rubric, results, build);
    ask_about_differences(isolated, units, again, questions.request.textures);
    Observations const differences = answers(isolated);
    judge_isolated(results, differences, where);
    results.remarks = find_remarks(units, again, differences);
    Observations const repaired = answers(ask_repaired(results, build.written()));
    explain(results, build.written(), repaired, where);
    FunctionSet const right_alone = unexplained(results, build.written(), repaired, where);
    take_credit(results, find_circular(right_alone, questions, answers));
    double const check_ms = ms_since(start) - compiled_ms - observe_ms;
    Grade const grade = score(results, build, rubric, options.lenient);
    write_pictures(results, options.out, where.envelopes);

    return make_report(submission, build, results, grade, rubric, {rubric.version, questions.sha256, questions.seed},
                       {build.ms, observe_ms, check_ms, ms_since(start)}, {options.for_tutor, cage.is_caged()});
}

void make_directory(std::filesystem::path const& directory)
{
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (!std::filesystem::is_directory(directory))
        throw std::invalid_argument("--out " + directory.string() + ": cannot be made: " + error.message());
    if (std::filesystem::exists(directory / "pictures") && !std::filesystem::exists(directory / "report.json"))
        throw std::invalid_argument("--out " + directory.string() +
                                    ": holds 'pictures' that are not ours; choose another");
    auto const trial = directory / (".testat-" + std::to_string(getpid()));
    bool const writable = std::ofstream(trial).is_open();
    std::filesystem::remove(trial, error);
    if (!writable)
        throw std::invalid_argument("--out " + directory.string() + ": cannot be written to");
}
}  // namespace

Report grade(GradeOptions const& options, Installation const& where)
{
    Submission const submission = read_submission(options.file);
    Rubric const rubric = select(read_rubric(where.rubric), options);
    make_directory(options.out);
    Report report;
    try {
        report = run_pipeline(submission, rubric, options, where);
    } catch (Interrupted const&) {
        throw;
    } catch (std::exception const& e) {
        report = make_not_gradable(submission, {rubric.version, "", options.seed}, e.what());
    }
    write_atomically(options.out / "report.json", to_text(report));
    return report;
}
}  // namespace testat
