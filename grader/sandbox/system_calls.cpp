#include "sandbox/system_calls.h"

#include "process/run.h"

#include <linux/filter.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace testat {
namespace {
void check(int result, char const* what)
{
    if (result != 0)
        throw std::runtime_error(std::string("seccomp: ") + what + " failed with " + std::to_string(-result));
}
}  // namespace

SystemCallFilter::SystemCallFilter(std::uint32_t otherwise) : context_(seccomp_init(otherwise))
{
    if (context_ == nullptr)
        throw std::runtime_error("seccomp: no filter can be made");
}

SystemCallFilter::~SystemCallFilter()
{
    seccomp_release(context_);
}

void SystemCallFilter::add(std::uint32_t action, std::vector<int> const& calls,
                           std::vector<scmp_arg_cmp> const& conditions)
{
    for (int call : calls)
        check(
            seccomp_rule_add_array(context_, action, call, static_cast<unsigned>(conditions.size()), conditions.data()),
            "adding a rule");
}

void SystemCallFilter::load() const
{
    check(seccomp_load(context_), "loading a filter");
}

std::vector<sock_filter> SystemCallFilter::program() const
{
    Descriptor const file = memory_file("filter");
    check(seccomp_export_bpf(context_, file.get()), "exporting a filter");
    struct stat status = {};
    fstat(file.get(), &status);
    std::vector<sock_filter> program(static_cast<std::size_t>(status.st_size) / sizeof(sock_filter));
    std::size_t const size = program.size() * sizeof(sock_filter);
    if (pread(file.get(), program.data(), size, 0) != static_cast<ssize_t>(size))
        throw std::runtime_error("seccomp: the filter cannot be read back");
    return program;
}

scmp_arg_cmp low_bits_are(unsigned argument, std::uint32_t mask, std::uint32_t value)
{
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

int landlock_version()
{
    long const version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return static_cast<int>(std::max(version, 0L));
}
}  // namespace testat
