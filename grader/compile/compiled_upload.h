#pragma once
#include "compile/compile.h"
#include "process/run.h"

namespace testat {
/// An upload built to be looked into rather than graded: in a cage that takes as long as it takes.
struct CompiledUpload {
    /// That the file does not compile is for `build` to say. Throws UnreadableInput, Interrupted, and
    /// std::runtime_error when something of ours fails.
    CompiledUpload(std::filesystem::path const& file, std::string const& compiler, Confinement confinement,
                   Installation const& where);

    Submission submission;
    Cage cage;
    TemporaryDirectory workplace;
    Build build;
};
}  // namespace testat
