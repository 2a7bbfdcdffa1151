#pragma once
#include "installation.h"
#include "report/text.h"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

/// `testat watch FILE`: a loop of `testat grade`, one on each save.
namespace testat {
struct WatchOptions {
    std::filesystem::path file;
    std::filesystem::path out;               ///< of the reports, each in place of the one before
    std::filesystem::path program;           ///< testat
    std::vector<std::string> grade_options;  ///< for `testat grade`, besides --out
    Language language = Language::en;
};

/// Grades now and on each save, and prints what has changed. Survives that the file does not compile or is gone for a
/// moment. Ends by Interrupted only; throws std::invalid_argument if there is no such file.
[[noreturn]] void watch(WatchOptions const& options, Installation const& where, std::ostream& text);
}  // namespace testat
