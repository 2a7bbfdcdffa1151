#pragma once
#include "protocol/request.h"

#include <map>
#include <vector>

namespace testat {
/// What time a request leaves for whom. Functions that hang get little from then on, and less the more of them there
/// are, so that they do not use up what others need.
class Accounts {
public:
    /// `hanging`: functions that have run into the limit in another request.
    Accounts(Limits const& limits, FunctionSet hanging) : limits_(limits), hanging_(hanging) {}

    /// CPU seconds for a group with these functions from the upload, `elapsed_s` seconds after the request came; 0 if
    /// there is no time left for it.
    double limit_for(FunctionSet functions, double elapsed_s);

    /// A group has taken so long.
    void charge(FunctionSet functions, double cpu_s, double wall_s, bool timed_out);

    /// Wall seconds for a group that has a limit of so many CPU seconds.
    static double wall_limit(double cpu_s) { return wall_per_cpu * cpu_s + 1; }

private:
    struct Account {
        double left_s;
        bool hangs;
    };
    static constexpr double wall_per_cpu = 2;

    Account& account_of(FunctionSet functions);

    Limits limits_;
    FunctionSet hanging_;
    double spent_s_ = 0;
    std::vector<FunctionSet> timed_out_;
    std::map<std::uint32_t, Account> accounts_;  ///< by the bits of the functions
};
}  // namespace testat
