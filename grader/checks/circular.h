#pragma once
#include "checks/run_checks.h"

#include <functional>

// Alone, every function is surrounded by the reference's. So two that are nothing but a call of each other are right,
// each of them, and nobody has written anything. They show in a picture that stays wrong although every function that
// is wrong alone is replaced.
namespace testat {
/// Answers a request, as the pipeline does.
using Ask = std::function<Observations(Request const&)>;

/// Those of `functions`, all of them right `alone`, that are right only because others of them are the reference's:
/// their checks fail by far when these come from the upload, too, and so do the others'. Running out of time is a
/// failure only of what was quick alone and has used its time itself: not where the upload's allowance is used up. Asks
/// nothing for fewer than two.
FunctionSet find_circular(FunctionSet functions, Observations const& alone, Questions const& questions, Ask const& ask);

/// Their checks have failed.
void take_credit(CheckResults& results, FunctionSet circular);
}  // namespace testat
