#pragma once
#include "checks/run_checks.h"

#include <functional>

// Alone, every function is surrounded by the reference's. So two that are nothing but a call of each other are right,
// each of them, and nobody has written anything. They show where the unit checks are asked once more with all
// functions from the upload that are right, or in a picture that stays wrong although every other one is replaced.
namespace testat {
/// Answers a request, as the pipeline does.
using Ask = std::function<Observations(Request const&)>;

/// Adds the unit checks of `functions`, all of these from the upload; without those that are slow alone.
void ask_in_company(Request& request, FunctionSet functions, Observations const& alone, Questions const& questions);

/// Whether a check that ask_in_company has added fails by far.
bool fail_in_company(Observations const& observations, Observations const& alone, Questions const& questions);

/// Those of `functions`, all of them right `alone`, that are right only because others of them are the reference's:
/// their checks fail by far when these come from the upload, too, and so do the others'. Running out of time is a
/// failure only of what was quick alone and has used its time itself: not where the upload's allowance is used up. Asks
/// nothing for fewer than two.
FunctionSet find_circular(FunctionSet functions, Observations const& alone, Questions const& questions, Ask const& ask);

/// Their checks have failed.
void take_credit(CheckResults& results, FunctionSet circular);
}  // namespace testat
