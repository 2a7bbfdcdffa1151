#pragma once
#include "model.h"
#include "rubric/rubric.h"

namespace testat {
/// CheckResults -> Grade, by the rubric alone.
Grade score(CheckResults const& results, Build const& build, Rubric const& rubric, bool lenient);

/// Half of `step` goes up, and so does what lies below it by no more than the roundings of the weights.
double round_half_up(double points, double step);
}  // namespace testat
