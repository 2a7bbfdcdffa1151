#pragma once
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

/// What the tests of the corpus have in common.
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
