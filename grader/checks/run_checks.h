#pragma once
#include "checks/textures.h"
#include "installation.h"
#include "model.h"
#include "rubric/rubric.h"

namespace testat {
/// What the probe is asked for an upload, and what the judge remembers to understand the answers.
struct Questions {
    Request request;
    std::uint64_t seed = 0;
    std::string sha256;  ///< of what is asked of a whole upload: names the test set
};

/// The unit checks of the rubric for the functions that `available` has, isolated. Metamorphic checks ask what depends
/// on the upload, too; the sha256 of the questions does not.
Questions make_questions(Rubric const& rubric, FunctionSet available, std::uint64_t seed,
                         std::string const& upload_sha256 = "");

/// Observations -> CheckResults, without pictures yet. Runs every check of the rubric as a GoogleTest case (once in a
/// process). Checks without an observation count as not passed.
CheckResults check(Observations const& observations, Questions const& questions, Rubric const& rubric);
}  // namespace testat
