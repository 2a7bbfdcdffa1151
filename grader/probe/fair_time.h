#pragma once
#include <algorithm>

namespace testat {
/// Wall time as it counts against a group's limit. A child that computes as fast as the machine lets it uses no more of
/// it than twice its CPU time: that the machine has too little time for it is not its fault. One that sleeps uses all
/// of it. (The judge, who sees how long processes wait for a processor, keeps the limit of the whole upload.)
class FairTime {
public:
    /// In so many seconds by the clock all threads together have computed for `cpu_s`.
    void pass(double wall_s, double cpu_s)
    {
        constexpr double awake = 0.02;
        spent_s_ += cpu_s < awake * wall_s ? wall_s : std::min(wall_s, 2 * cpu_s);
    }

    double spent_s() const { return spent_s_; }

private:
    double spent_s_ = 0;
};
}  // namespace testat
