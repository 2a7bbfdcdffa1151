#pragma once
#include <sys/types.h>

#include <cstddef>

namespace testat {
/// What a process and all that it has started use, as far as they can still be told to belong together: whoever loses
/// its parent goes to the first process of its namespace.
struct TreeUsage {
    double cpu_s = 0;        ///< of those that have ended and were waited for, too
    std::size_t memory = 0;  ///< bytes: what each has for itself, and the largest part that one shares
};

/// Read from /proc; processes that end meanwhile count as far as they were read.
TreeUsage usage_of_tree(pid_t root);
}  // namespace testat
