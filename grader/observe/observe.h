#pragma once
#include "installation.h"
#include "model.h"
#include "sandbox/cage.h"

namespace testat {
/// Build -> Observations. Runs the probe once, in the cage, on the whole request. Whatever the upload does is a
/// GroupStatus; groups for which the cage's allowance is not enough have timed out. A probe that cannot start or does
/// not come to its end, or a machine that fails it, throws std::runtime_error.
Observations observe(Build const& build, Request const& request, Installation const& where, Cage& cage);

/// Cuts an answer stream into groups. Statuses and texts are checked for range; a stream that ends early leaves the
/// rest of the groups `lost`. Throws std::runtime_error if there is not even a greeting.
Observations decode_answers(Request const& request, std::vector<std::byte> const& stream);
}  // namespace testat
