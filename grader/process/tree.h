#pragma once
#include <sys/types.h>

#include <cstddef>
#include <map>

namespace testat {
/// What a process and all that it has started use, as far as they can still be told to belong together: whoever loses
/// its parent goes to the first process of its namespace.
struct TreeUsage {
    double cpu_s = 0;                  ///< of those that have ended and were waited for, too
    std::map<pid_t, double> waited_s;  ///< for a processor, by the first threads of those that live
    std::size_t memory = 0;            ///< bytes: what each has for itself, and the largest part that one shares
};

/// Read from /proc; processes that end meanwhile count as far as they were read.
TreeUsage usage_of_tree(pid_t root);

/// How many processes the kernel has killed for want of memory since it started, on the whole machine; 0 if it does not
/// say.
long long out_of_memory_kills();
}  // namespace testat
