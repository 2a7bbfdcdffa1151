#pragma once
#include "report/report.h"
#include "score/score.h"

/// A small grading: two functions of one task, made up.
namespace testat {
/// wrap_clamp (1 point: *Inside .25, Negative .75) with one picture, wrap_repeat (1 point: *Inside 1) with none.
Rubric example_rubric();

/// All checks of the rubric passed, all pictures right.
CheckResults passed_results(Rubric const& rubric);

/// Compiles, and defines all functions.
Build whole_build();

/// Does not compile, because of line 3 in wrap_clamp.
Build mended_build();

CheckResult& find_result(CheckResults& results, std::string const& name);
}  // namespace testat
