#pragma once
#include "installation.h"
#include "model.h"
#include "sandbox/cage.h"

namespace testat {
struct CompileOptions {
    std::string compiler = "g++";    ///< "g++" or "clang++"
    std::string standard = "c++17";  ///< the rubric's
    std::vector<std::string> flags;  ///< behind our own
};

/// Reads what was handed in. A file that cannot be C++ (empty, binary, over 1 MB) is `refused`, which is a value.
/// Throws UnreadableInput if there is no such regular file or it cannot be read.
Submission read_submission(std::filesystem::path const& file);

/// Submission -> Build. Compiles in the cage and into `directory`, links against trampolines and framework, and checks
/// the symbols. The upload's mistakes are diagnostics; a missing compiler or a full disk throws std::runtime_error.
Build compile(Submission const& submission, CompileOptions const& options, std::filesystem::path const& directory,
              Installation const& where, Cage& cage);

/// Wrong usage: the file to grade is not there, or not readable.
struct UnreadableInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};
}  // namespace testat
