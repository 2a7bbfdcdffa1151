#pragma once
#include "envelopes/envelope.h"
#include "model.h"

namespace testat {
Comparison compare_picture(std::string const& name, Picture const& picture, Envelope const& envelope);

/// 1 - log(outside / limit) / log(all / limit); all three are one larger where the limit is 0.
double picture_score(std::size_t outside, std::size_t limit, std::size_t all);

/// The rendering in the observation of that name, compared with the envelope; where there is none, nothing of it is
/// right.
Rendering judge_rendering(std::string const& picture, std::string const& group, Observations const& observations,
                          Envelope const& envelope);
}  // namespace testat
