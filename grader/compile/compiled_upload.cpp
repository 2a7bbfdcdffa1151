#include "compile/compiled_upload.h"

#include "rubric/rubric.h"

#include <cmath>

namespace testat {
namespace {
constexpr Allowance as_long_as_it_takes{HUGE_VAL, HUGE_VAL};
}  // namespace

CompiledUpload::CompiledUpload(std::filesystem::path const& file, std::string const& compiler, Confinement confinement,
                               Installation const& where)
    : submission(read_submission(file)),
      cage(confinement, as_long_as_it_takes),
      build(compile(submission, {compiler, read_rubric(where.rubric).standard, {}}, workplace.path(), where, cage))
{
}
}  // namespace testat
