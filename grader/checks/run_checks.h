#pragma once
#include "checks/textures.h"
#include "installation.h"
#include "model.h"
#include "rubric/rubric.h"

namespace testat {
/// Everything the probe is asked for an upload, and what the judge remembers to understand the answers.
struct Questions {
    Request request;
    std::uint64_t seed = 0;
    std::string sha256;  ///< of the request, upload not included: names the test set
};

/// The unit checks of the rubric for the functions that `available` has, isolated; their pictures, isolated and, if
/// `as_submitted`, with the whole upload in place.
Questions make_questions(Rubric const& rubric, FunctionSet available, bool as_submitted, std::uint64_t seed);

/// Observations -> CheckResults. Runs every check of the rubric as a GoogleTest case (once in a process), and compares
/// the pictures with their envelopes. Checks without an observation count as not passed.
CheckResults check(Observations const& observations, Questions const& questions, Rubric const& rubric,
                   Installation const& where);

/// Which further pictures would tell why those as submitted are wrong: each rendered with the functions that are not
/// entirely right (the suspects) replaced by the reference, and with one suspect at a time left in. Nothing to ask if
/// there is nothing to explain.
Request repair_questions(CheckResults const& results);

/// Fills explained_by from the answers to repair_questions.
void explain(CheckResults& results, Observations const& repaired, Installation const& where);
}  // namespace testat
