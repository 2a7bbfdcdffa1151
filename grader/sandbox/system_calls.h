#pragma once
#include <seccomp.h>

#include <cstdint>
#include <vector>

struct sock_filter;

/// Filters of system calls (libseccomp). What is refused fails with an error number: a file that asks for more than it
/// needs goes on, without it.
namespace testat {
/// Owns a filter under construction.
class SystemCallFilter {
public:
    /// What is not listed does `otherwise`: SCMP_ACT_ALLOW, or SCMP_ACT_ERRNO(EPERM).
    explicit SystemCallFilter(std::uint32_t otherwise);
    ~SystemCallFilter();
    SystemCallFilter(SystemCallFilter const&) = delete;
    SystemCallFilter& operator=(SystemCallFilter const&) = delete;

    /// Calls of these numbers (SCMP_SYS) do `action`, where all conditions on their arguments hold. Throws
    /// std::runtime_error if the library refuses.
    void add(std::uint32_t action, std::vector<int> const& calls, std::vector<scmp_arg_cmp> const& conditions = {});

    /// For this process and all that it will start, for ever. Throws std::runtime_error.
    void load() const;

    /// As the kernel takes it. Throws std::runtime_error.
    std::vector<sock_filter> program() const;

private:
    scmp_filter_ctx context_;
};

/// The 32 bits of an argument that the kernel looks at where it takes an int.
scmp_arg_cmp low_bits_are(unsigned argument, std::uint32_t mask, std::uint32_t value);

/// The version of Landlock's interface that the kernel has; 0 if none.
int landlock_version();
}  // namespace testat
