#include "probe/accounts.h"

#include <algorithm>

namespace testat {
double Accounts::limit_for(FunctionSet functions, double elapsed_s)
{
    Account const& account = account_of(functions);
    double const cpu_left_s = limits_.all_s - spent_s_;
    double const wall_left_s = limits_.wall_s - elapsed_s;
    if (!(cpu_left_s > 0 && wall_left_s > 0 && account.left_s > 0))
        return 0;
    constexpr double shares = 4;
    double const share_s = std::min(cpu_left_s, wall_left_s / wall_per_cpu) / shares;
    double const limit_s = std::min(account.hangs ? limits_.after_timeout_s : limits_.group_s, share_s);
    return std::max(1.0, std::min(limit_s, account.left_s));
}

void Accounts::charge(FunctionSet functions, double cpu_s, double wall_s, bool timed_out)
{
    Account& account = account_of(functions);
    spent_s_ += cpu_s;
    account.left_s -= std::max(cpu_s, wall_s / wall_per_cpu);
    if (!timed_out)
        return;
    timed_out_.push_back(functions);
    if (!account.hangs)
        account = {std::min(account.left_s, limits_.hanging_s), true};
}

Accounts::Account& Accounts::account_of(FunctionSet functions)
{
    auto const found = accounts_.find(functions.bits());
    if (found != accounts_.end())
        return found->second;
    bool const hangs =
        hanging_.meets(functions) || std::any_of(timed_out_.begin(), timed_out_.end(),
                                                 [&](FunctionSet hanging) { return hanging.is_subset_of(functions); });
    Account const account{hangs ? limits_.hanging_s : limits_.total_s, hangs};
    return accounts_.emplace(functions.bits(), account).first->second;
}
}  // namespace testat
