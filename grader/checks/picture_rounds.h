#pragma once
#include "installation.h"
#include "model.h"
#include "rubric/rubric.h"

/// Pictures are asked for in rounds, each only as far as the one before leaves something open: as submitted, then twice
/// isolated, then repaired. Without functions to run, or nothing to ask, a request has no groups.
namespace testat {
/// Every picture of the rubric as submitted; none if the file does not link.
Request ask_submitted(Rubric const& rubric, CheckResults const& results, Build const& build);

/// Fills `pictures` with what is expected and what was submitted.
void judge_submitted(CheckResults& results, Rubric const& rubric, Build const& build, Observations const& observations,
                     Installation const& where);

/// Each picture for each of its functions, the others from the reference. A function that passes all its unit checks is
/// right in isolation, too, if the picture is right as submitted, or once all functions that fail one (the suspects)
/// are replaced: the first time, only the latter picture is asked for in the place of all theirs, the second time, what
/// is still open where that one is wrong.
Request ask_isolated(Rubric const& rubric, CheckResults const& results, Build const& build);

/// Fills in what the pictures say of each function.
void judge_isolated(CheckResults& results, Observations const& observations, Installation const& where);

/// Which further pictures would tell why those as submitted are wrong: each rendered with the functions that are not
/// entirely right (the suspects) replaced by the reference, and with one suspect at a time left in. What such a picture
/// looks like without a function that is not `written` is known, and so is what judge_isolated has seen.
Request ask_repaired(CheckResults const& results, FunctionSet written);

/// The functions that are right alone and have a hand in a picture that is wrong without its suspects.
FunctionSet unexplained(CheckResults const& results, FunctionSet written, Observations const& repaired,
                        Installation const& where);

/// Fills explained_by from the answers to ask_repaired.
void explain(CheckResults& results, FunctionSet written, Observations const& repaired, Installation const& where);

/// The group that asks for a picture as submitted. `culling`: objects that a ray cannot meet may be left out.
Group submitted_group(std::string const& picture, bool culling);
}  // namespace testat
