#include "stress/command.h"

#include "compile/compiled_upload.h"
#include "stress/stress_report.h"

namespace testat {
std::string stress_file(StressFile const& options, Installation const& where)
{
    CompiledUpload upload(options.file, options.compiler, options.confinement, where);
    make_output_directory(options.out);
    Build const& build = upload.build;
    auto const results =
        build.library.empty() ? std::vector<FunctionStress>() : stress(build, options.stress, where, upload.cage);
    Report const document = stress_to_json(upload.submission, build, options.stress, results);
    write_atomically(options.out / "stress.json", to_text(document));
    write_atomically(options.out / "stress.svg", stress_to_svg(results, upload.submission.file, options.language));
    return stress_to_text(document, options.language);
}
}  // namespace testat
