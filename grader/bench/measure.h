#pragma once
#include "bench/filters.h"

namespace testat::bench {
/// What one filter did with some footprints.
struct Measured {
    double seconds = 0;  ///< CPU time of this thread, the least of all rounds
    Colours colours;
};

/// Runs all filters in turn, so many rounds: what disturbs one round disturbs all filters alike.
std::vector<Measured> measure(std::vector<LookUp> const& filters, Footprints const& footprints, int rounds);
}  // namespace testat::bench
