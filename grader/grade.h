#pragma once
#include "compile/compile.h"
#include "report/report.h"
#include "rubric/rubric.h"
#include "stages.h"

#include <set>

namespace testat {
struct GradeOptions {
    std::filesystem::path file;
    std::filesystem::path out;  ///< directory of report.json and pictures
    std::set<char> tasks;       ///< empty: all
    std::uint64_t seed = 1;
    bool for_tutor = true;
    bool lenient = false;
    std::string compiler = "g++";
    std::vector<std::string> compiler_flags;  ///< behind our own
    Confinement confinement = Confinement::cage;
};

/// Grades a file and writes `out`/report.json with its pictures. The report is whole or, if something of ours fails,
/// says "not_gradable"; `stages` tells where the time went. Throws UnreadableInput and std::invalid_argument for wrong
/// usage, Interrupted on Ctrl-C.
Report grade(GradeOptions const& options, Installation const& where, Stages& stages);
}  // namespace testat
