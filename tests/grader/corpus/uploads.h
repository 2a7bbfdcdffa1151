#pragma once
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

/// What the tests of the corpus have in common. The first line of a file says how it must be graded:
///   // verdict: {"loses": {"wrap_repeat": [0.5, 1]}, "says": {"wrap_repeat": "partial"},
///                "mistake": {"wrap_repeat": "repeat_abs"}, "policy": [], "prints": []}      (on one line)
/// loses: points that functions lose before policy, from and to; every other function has all of its points.
/// says: their words in report.json; every other function is "correct".
/// mistake: how their mistakes are called; no other function's is named.
/// policy: what of the sheet's policies applies; none if it is left out.
/// prints: functions whose checks must say that they print.
/// remarks: the ids of exactly the remarks that the report makes; none if it is left out.
/// sanitizers: false for what shows with the system's own heap and signals only; true if it is left out.
/// by_hand: what GRADING's table of mistakes leaves of the points before policy, worked out without the grader.
namespace testat {
/// An upload and the compiler to grade it with.
struct Case {
    std::filesystem::path file;
    std::string compiler;
};

/// Every composed upload of these folders, with every compiler, ordered by file.
std::vector<Case> cases_in(std::vector<std::string> const& folders);

/// "wrong_repeat_abs_clang"
std::string name_of(testing::TestParamInfo<Case> const& info);

/// The verdict on line 1. Throws std::runtime_error if there is none.
Json read_verdict(std::filesystem::path const& file);
}  // namespace testat
