#include "probe/restrictions.h"

#include "process/run.h"
#include "sandbox/system_calls.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace testat {
namespace {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// Stands in a filter for the process that it will belong to, which is not known yet.
constexpr std::uint32_t own_process = 0x7e57a700;

[[noreturn]] void fail(char const* what)
{
    throw std::system_error(errno, std::generic_category(), what);
}

void allow_computing(SystemCallFilter& filter)
{
    std::uint32_t const allowed = SCMP_ACT_ALLOW;
    filter.add(allowed, {SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(write), SCMP_SYS(writev), SCMP_SYS(lseek),
                         SCMP_SYS(close), SCMP_SYS(fstat)});
    filter.add(allowed, {SCMP_SYS(brk), SCMP_SYS(munmap), SCMP_SYS(futex), SCMP_SYS(getrandom)});
    filter.add(allowed,
               {SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
                SCMP_SYS(timer_create), SCMP_SYS(timer_settime), SCMP_SYS(timer_delete)});
    filter.add(allowed, {SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday), SCMP_SYS(time),
                         SCMP_SYS(clock_nanosleep), SCMP_SYS(nanosleep), SCMP_SYS(restart_syscall)});
    filter.add(allowed, {SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(getuid), SCMP_SYS(geteuid), SCMP_SYS(getgid),
                         SCMP_SYS(getegid), SCMP_SYS(getrusage), SCMP_SYS(times), SCMP_SYS(sched_yield),
                         SCMP_SYS(sched_getaffinity), SCMP_SYS(getcpu)});
    filter.add(allowed, {SCMP_SYS(exit), SCMP_SYS(exit_group)});
    filter.add(allowed, {SCMP_SYS(mprotect)}, {low_bits_are(2, PROT_EXEC, 0)});
    // What is shared stays in memory when one page of it is kept, and is no longer counted.
    filter.add(allowed, {SCMP_SYS(mmap)}, {low_bits_are(2, PROT_EXEC, 0), low_bits_are(3, MAP_SHARED, 0)});
    filter.add(allowed, {SCMP_SYS(mremap)}, {low_bits_are(3, MREMAP_FIXED, 0)});  // not over code
    // Not what writes pages of files out: which are in memory would tell one child of another.
    for (std::uint32_t advice : {MADV_DONTNEED, MADV_FREE, MADV_HUGEPAGE, MADV_NOHUGEPAGE, MADV_POPULATE_WRITE})
        filter.add(allowed, {SCMP_SYS(madvise)}, {low_bits_are(2, ~0u, advice)});
    filter.add(allowed, {SCMP_SYS(tgkill)}, {low_bits_are(0, ~0u, own_process)});  // abort() and the like
}

void allow_threads(SystemCallFilter& filter)
{
    unsigned const thread = CLONE_THREAD | CLONE_VM;
    filter.add(SCMP_ACT_ALLOW, {SCMP_SYS(clone)}, {low_bits_are(0, thread, thread)});
    filter.add(SCMP_ACT_ALLOW, {SCMP_SYS(set_robust_list), SCMP_SYS(rseq)});
    filter.add(SCMP_ACT_ERRNO(ENOSYS), {SCMP_SYS(clone3)});  // the C library then takes clone
}

/// What a child opens while it has nothing but standard input and output.
constexpr std::uint32_t first_opened = 3;

/// What loading a library and the second filter need on top. Code comes from a file that was opened, which Landlock
/// leaves no other than the upload; what stdout goes to is no such file.
void allow_loading(SystemCallFilter& filter)
{
    filter.add(SCMP_ACT_ALLOW, {SCMP_SYS(openat), SCMP_SYS(pread64), SCMP_SYS(newfstatat)});
    filter.add(SCMP_ACT_ALLOW, {SCMP_SYS(mmap)},
               {low_bits_are(2, PROT_EXEC | PROT_WRITE, PROT_EXEC), low_bits_are(3, MAP_ANONYMOUS, 0),
                low_bits_are(4, ~0u, first_opened)});
    filter.add(SCMP_ACT_ALLOW, {SCMP_SYS(seccomp)});
}

std::vector<sock_filter> make_computing(bool threads)
{
    SystemCallFilter filter(SCMP_ACT_ERRNO(EPERM));
    allow_computing(filter);
    allow_loading(filter);
    if (threads)
        allow_threads(filter);
    return filter.program();
}

std::vector<sock_filter> make_loaded()
{
    SystemCallFilter filter(SCMP_ACT_ALLOW);
    std::uint32_t const refused = SCMP_ACT_ERRNO(EPERM);
    filter.add(refused, {SCMP_SYS(openat), SCMP_SYS(pread64), SCMP_SYS(newfstatat), SCMP_SYS(seccomp)});
    filter.add(refused, {SCMP_SYS(mmap)}, {low_bits_are(2, PROT_EXEC, PROT_EXEC)});
    return filter.program();
}

void load(std::vector<sock_filter> program)
{
    for (auto& instruction : program)
        if (instruction.k == own_process)
            instruction.k = static_cast<std::uint32_t>(getpid());
    sock_fprog const whole{static_cast<unsigned short>(program.size()), program.data()};
    if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &whole) != 0)
        fail("the filter of system calls");
}

void allow_reading(int ruleset, std::string const& file)
{
    Descriptor const opened(open(file.c_str(), O_PATH | O_CLOEXEC));
    landlock_path_beneath_attr rule = {};
    rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
    rule.parent_fd = opened.get();
    if (opened.get() < 0 || syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
        fail("a Landlock rule for the upload");
}

/// Of all files this process may open the one given, to read it.
void read_only(std::string const& file)
{
    landlock_ruleset_attr handled = {};
    handled.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // everything in the first version
    Descriptor const ruleset(static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0)));
    if (ruleset.get() < 0)
        fail("a Landlock ruleset");
    allow_reading(ruleset.get(), file);
    if (syscall(SYS_landlock_restrict_self, ruleset.get(), 0) != 0)
        fail("Landlock");
}
}  // namespace

Restrictions::Restrictions(std::string upload) : upload_(std::move(upload))
{
    if (sanitized)
        return;
    computing_ = make_computing(false);
    computing_with_threads_ = make_computing(true);
    loaded_ = make_loaded();
}

void Restrictions::before_loading(bool threads) const
{
    if (sanitized)
        return;
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) != 0)
        fail("prctl");
    if (landlock_version() > 0)
        read_only(upload_);
    load(threads ? computing_with_threads_ : computing_);
}

void Restrictions::after_loading() const
{
    if (!sanitized)
        load(loaded_);
}
}  // namespace testat
