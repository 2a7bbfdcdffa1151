#pragma once
#include "envelopes/envelope.h"
#include "model.h"

namespace testat {
/// How a picture compares with its envelope.
struct Comparison {
    std::size_t outside = 0;
    std::size_t limit = 0;
    double score = 0;  ///< 1 while outside <= limit, then falling with the logarithm to 0 when all are outside
    double rms = 0;    ///< over all channels; infinite if a value is not finite
    double max_error = 0;
};

Comparison compare_picture(std::string const& name, Picture const& picture, Envelope const& envelope);

/// 1 - log(outside / limit) / log(all / limit); all three are one larger where the limit is 0.
double picture_score(std::size_t outside, std::size_t limit, std::size_t all);

/// The results for every picture that the observations hold, in the order of `names`.
PictureResult judge_picture(std::string const& name, std::vector<Function> const& functions,
                            Observations const& observations, std::filesystem::path const& envelopes);
}  // namespace testat
