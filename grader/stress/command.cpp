#include "stress/command.h"

#include "compile/compile.h"
#include "process/run.h"
#include "rubric/rubric.h"
#include "stress/stress_report.h"

#include <unistd.h>

#include <cmath>

namespace testat {
namespace {
void make_directory(std::filesystem::path const& directory)
{
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (!std::filesystem::is_directory(directory))
        throw std::invalid_argument("--out " + directory.string() + ": cannot be made: " + error.message());
    if (access(directory.c_str(), W_OK) != 0)
        throw std::invalid_argument("--out " + directory.string() + ": cannot be written to");
}
}  // namespace

std::string stress_file(StressFile const& options, Installation const& where)
{
    Submission const submission = read_submission(options.file);
    constexpr Allowance as_long_as_it_takes{HUGE_VAL, HUGE_VAL};
    Cage cage(options.confinement, as_long_as_it_takes);
    make_directory(options.out);
    TemporaryDirectory const workplace;
    CompileOptions compile_options;
    compile_options.compiler = options.compiler;
    compile_options.standard = read_rubric(where.rubric).standard;
    Build const build = compile(submission, compile_options, workplace.path(), where, cage);
    auto const results =
        build.library.empty() ? std::vector<FunctionStress>() : stress(build, options.stress, where, cage);
    Report const document = stress_to_json(submission, build, options.stress, results);
    write_atomically(options.out / "stress.json", to_text(document));
    write_atomically(options.out / "stress.svg", stress_to_svg(results, submission.file, options.language));
    return stress_to_text(document, options.language);
}
}  // namespace testat
