#pragma once
#include "model.h"

#include <string_view>

namespace testat {
/// Reads the messages of g++, clang++, mold and the GNU linkers. `source` is the file name the compiler was given and
/// `shown` the name to report for it. At most `most` messages, errors before everything else; texts are cleaned.
std::vector<Diagnostic> parse_diagnostics(std::string_view output, std::string const& source, std::string const& shown,
                                          std::size_t most = 20);
}  // namespace testat
