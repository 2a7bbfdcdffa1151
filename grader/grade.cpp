#include "grade.h"

#include "checks/circular.h"
#include "checks/picture_rounds.h"
#include "checks/remarks.h"
#include "checks/run_checks.h"
#include "observe/observe.h"
#include "process/run.h"
#include "report/pictures.h"
#include "score/score.h"

namespace testat {
namespace {
Rubric select(Rubric rubric, GradeOptions const& options)
{
    if (!options.tasks.empty())
        rubric = only_tasks(std::move(rubric), options.tasks);
    return options.for_tutor ? rubric : only_public(std::move(rubric));
}

/// Starts no probe where there is nothing to run, or nothing to ask.
Observations observe_if_any(Build const& build, Request const& request, Installation const& where, Cage& cage)
{
    return build.library.empty() || request.groups.empty() ? Observations() : observe(build, request, where, cage);
}

/// The pipeline.
Report run_pipeline(Submission const& submission, Rubric const& rubric, GradeOptions const& options,
                    Installation const& where, Stages& stages)
{
    Cage cage(options.confinement);
    TemporaryDirectory const workplace;
    stages.end("read");
    Build const build =
        compile(submission, {options.compiler, rubric.standard, options.compiler_flags}, workplace.path(), where, cage);
    stages.end("compile");
    Questions const questions = make_questions(rubric, build.written(), options.seed, submission.sha256);
    auto const answers = [&](char const* stage, Request const& request) {
        stages.end("check");
        Observations observations = observe_if_any(build, request, where, cage);
        stages.end(stage);
        return observations;
    };

    Observations const units = answers("observe: unit checks", questions.request);
    CheckResults results = check(units, questions, rubric);
    Request submitted = ask_submitted(rubric, results, build);
    ask_again(submitted, units, questions.request.textures);
    FunctionSet const right_alone = results.passing() & build.written();
    ask_in_company(submitted, right_alone, units, questions);
    Observations const again = answers("observe: as submitted", submitted);
    judge_submitted(results, rubric, build, again, where);
    Request isolated = ask_isolated(rubric, results, build);
    ask_about_differences(isolated, units, again, questions.request.textures);
    Observations const differences = answers("observe: isolated", isolated);
    judge_isolated(results, differences, where);
    judge_isolated(results, answers("observe: isolated", ask_isolated(rubric, results, build)), where);
    results.remarks = find_remarks(units, again, differences);
    Observations const repaired = answers("observe: explain", ask_repaired(results, build.written()));
    explain(results, build.written(), repaired, where);
    FunctionSet const suspicious =
        fail_in_company(again, units, questions) ? right_alone : unexplained(results, build.written(), repaired, where);
    auto const together = [&](Request const& request) { return answers("observe: together", request); };
    take_credit(results, find_circular(suspicious, units, questions, together));
    Grade const grade = score(results, build, rubric, options.lenient);
    stages.end("check");
    write_pictures(results, options.out, where.envelopes);
    stages.end("write pictures");

    Timing const timing{stages.wall_ms("compile"), stages.wall_ms("observe"), stages.wall_ms("check"),
                        stages.wall_ms()};
    return make_report(submission, build, results, grade, rubric, {rubric.version, questions.sha256, questions.seed},
                       timing, {options.for_tutor, cage.is_caged()});
}

/// Pictures of somebody else's would be lost.
void check_pictures(std::filesystem::path const& out)
{
    if (std::filesystem::exists(out / "pictures") && !std::filesystem::exists(out / "report.json"))
        throw std::invalid_argument("--out " + out.string() + ": holds 'pictures' that are not ours; choose another");
}
}  // namespace

Report grade(GradeOptions const& options, Installation const& where, Stages& stages)
{
    Submission const submission = read_submission(options.file);
    Rubric const rubric = select(read_rubric(where.rubric), options);
    make_output_directory(options.out);
    check_pictures(options.out);
    Report report;
    try {
        report = run_pipeline(submission, rubric, options, where, stages);
    } catch (Interrupted const&) {
        throw;
    } catch (std::exception const& e) {
        report = make_not_gradable(submission, {rubric.version, "", options.seed}, e.what());
    }
    write_atomically(options.out / "report.json", to_text(report));
    stages.end("write report");
    return report;
}
}  // namespace testat
