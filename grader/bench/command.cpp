#include "bench/command.h"

#include "bench/bench_report.h"
#include "compile/compile.h"
#include "process/run.h"
#include "rubric/rubric.h"

#include <unistd.h>

#include <cmath>
#include <optional>

namespace testat::bench {
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

std::string write(BenchFile const& options, BenchResults const& results, Submission const* submission,
                  Build const* build)
{
    Report const document = bench_to_json(results, submission, build);
    std::string const file = submission == nullptr ? "" : submission->file;
    write_atomically(options.out / "bench.json", to_text(document));
    write_atomically(options.out / "bench.svg", bench_to_svg(results, file, options.language));
    return bench_to_text(document, options.language);
}

std::string bench_upload(BenchFile const& options, Installation const& where)
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
    return write(options, run_bench({&build, &cage}, options.bench, where), &submission, &build);
}
}  // namespace

std::string bench_file(BenchFile const& options, Installation const& where)
{
    if (!options.file.empty())
        return bench_upload(options, where);
    make_directory(options.out);
    return write(options, run_bench({}, options.bench, where), nullptr, nullptr);
}
}  // namespace testat::bench
