#include "bench/command.h"

#include "bench/bench_report.h"
#include "compile/compiled_upload.h"

namespace testat::bench {
namespace {
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
    CompiledUpload upload(options.file, options.compiler, options.confinement, where);
    make_output_directory(options.out);
    return write(options, run_bench({&upload.build, &upload.cage}, options.bench, where), &upload.submission,
                 &upload.build);
}
}  // namespace

std::string bench_file(BenchFile const& options, Installation const& where)
{
    if (!options.file.empty())
        return bench_upload(options, where);
    make_output_directory(options.out);
    return write(options, run_bench({}, options.bench, where), nullptr, nullptr);
}
}  // namespace testat::bench
