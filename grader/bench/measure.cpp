#include "bench/measure.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace testat::bench {
namespace {
double thread_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}
}  // namespace

std::vector<Measured> measure(std::vector<LookUp> const& filters, Footprints const& footprints, int rounds)
{
    std::vector<Measured> results(filters.size(), {HUGE_VAL, Colours(footprints.size())});
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < filters.size(); ++i) {
            double const start = thread_seconds();
            filters[i](footprints.data(), footprints.size(), results[i].colours.data());
            results[i].seconds = std::min(results[i].seconds, thread_seconds() - start);
        }
    return results;
}
}  // namespace testat::bench
