#pragma once
#include "model.h"

#include <string_view>

namespace testat {
/// Reads the messages of g++, clang++, mold and the GNU linkers. `source` is the file name the compiler was given and
/// `shown` the name to report for it. At most `most` messages, errors before everything else; texts are cleaned.
std::vector<Diagnostic> parse_diagnostics(std::string_view output, std::string const& source, std::string const& shown,
                                          std::size_t most = 20);

/// The first error in such an output, and what it may belong to.
struct FirstError {
    Diagnostic error;
    std::vector<int> lines;  ///< of `source`: its own, then those where the macro or template was used that it lies in
    std::string referrer;    ///< demangled name of the function that refers to what the linker lacks, or empty
};

std::optional<FirstError> find_first_error(std::string_view output, std::string const& source,
                                           std::string const& shown);
}  // namespace testat
