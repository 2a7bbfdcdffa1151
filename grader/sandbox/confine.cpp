// The last of our programs before a stranger's begins: started by bubblewrap inside the mounts (see cage.h), it gives
// up what is left to give up and becomes the program it was asked for.
#include "process/run.h"
#include "sandbox/system_calls.h"

#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <system_error>

namespace testat {
namespace {
[[noreturn]] void fail(std::string const& what)
{
    throw std::system_error(errno, std::generic_category(), what);
}

/// Arguments: UID READY CPU_S ADDRESS_SPACE FILE_SIZE PROCESSES PROGRAM ARGUMENT...
/// A zero limit is no limit; UID 0 stands for the one we have.
struct Order {
    explicit Order(char** argv)
        : uid(static_cast<uid_t>(number(argv[1]))),
          ready(static_cast<int>(number(argv[2]))),
          cpu_s(number(argv[3])),
          address_space(number(argv[4])),
          file_size(number(argv[5])),
          processes(number(argv[6])),
          command(argv + 7)
    {
    }
    static constexpr int least_arguments = 8;
    static rlim_t number(char const* text) { return std::strtoull(text, nullptr, 10); }

    uid_t uid;
    int ready;
    rlim_t cpu_s;
    rlim_t address_space;
    rlim_t file_size;
    rlim_t processes;
    char** command;
};

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard)
{
    rlimit const value{soft, hard};
    if (setrlimit(resource, &value) != 0)
        fail("setrlimit");
}

void set_limits(Order const& order)
{
    constexpr rlim_t open_files = 128;
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_NOFILE, open_files, open_files);
    limit(RLIMIT_NPROC, order.processes, order.processes);
    limit(RLIMIT_MSGQUEUE, 0, 0);
    limit(RLIMIT_MEMLOCK, 0, 0);
    if (order.cpu_s > 0)
        limit(RLIMIT_CPU, order.cpu_s, order.cpu_s + 1);
    if (order.address_space > 0)
        limit(RLIMIT_AS, order.address_space, order.address_space);
    if (order.file_size > 0)
        limit(RLIMIT_FSIZE, order.file_size, order.file_size);
}

/// The kernel counts the processes of root without a limit, and those of other users apart.
void become_user(uid_t uid)
{
    if (uid == 0)
        return;
    if (setgroups(0, nullptr) != 0 || setresgid(uid, uid, uid) != 0 || setresuid(uid, uid, uid) != 0)
        fail("becoming user " + std::to_string(uid));
}

/// What neither a compiler nor the probe's server needs. The children that run an upload get a filter that lists what
/// they may do instead (probe/restrictions.h).
void refuse_system_calls()
{
    std::uint32_t const refused = SCMP_ACT_ERRNO(EPERM);
    SystemCallFilter filter(SCMP_ACT_ALLOW);
    // No other processes' business.
    filter.add(refused, {SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev), SCMP_SYS(kcmp),
                         SCMP_SYS(pidfd_getfd), SCMP_SYS(process_madvise), SCMP_SYS(process_mrelease),
                         SCMP_SYS(perf_event_open), SCMP_SYS(setpriority), SCMP_SYS(ioprio_set)});
    // No other view of the system.
    filter.add(refused, {SCMP_SYS(mount), SCMP_SYS(umount2), SCMP_SYS(pivot_root), SCMP_SYS(chroot), SCMP_SYS(unshare),
                         SCMP_SYS(setns), SCMP_SYS(fsopen), SCMP_SYS(fspick), SCMP_SYS(fsmount), SCMP_SYS(move_mount),
                         SCMP_SYS(open_tree), SCMP_SYS(mount_setattr), SCMP_SYS(open_by_handle_at),
                         SCMP_SYS(name_to_handle_at), SCMP_SYS(personality)});
    for (unsigned space :
         {CLONE_NEWUSER, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWIPC, CLONE_NEWUTS, CLONE_NEWCGROUP})
        filter.add(refused, {SCMP_SYS(clone)}, {low_bits_are(0, space, space)});
    filter.add(SCMP_ACT_ERRNO(ENOSYS), {SCMP_SYS(clone3)});  // its flags lie in memory, where no filter sees them
    // Nobody to talk to.
    filter.add(refused, {SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(shmget), SCMP_SYS(shmat), SCMP_SYS(semget),
                         SCMP_SYS(semop), SCMP_SYS(msgget), SCMP_SYS(mq_open), SCMP_SYS(add_key), SCMP_SYS(request_key),
                         SCMP_SYS(keyctl)});
    // No rarely used doors of the kernel.
    filter.add(refused,
               {SCMP_SYS(bpf), SCMP_SYS(io_uring_setup), SCMP_SYS(io_uring_enter), SCMP_SYS(io_uring_register),
                SCMP_SYS(userfaultfd), SCMP_SYS(kexec_load), SCMP_SYS(kexec_file_load), SCMP_SYS(init_module),
                SCMP_SYS(finit_module), SCMP_SYS(delete_module), SCMP_SYS(reboot), SCMP_SYS(swapon), SCMP_SYS(swapoff),
                SCMP_SYS(acct), SCMP_SYS(quotactl), SCMP_SYS(syslog), SCMP_SYS(fanotify_init), SCMP_SYS(vhangup)});
    filter.load();
}

[[noreturn]] void become(Order const& order)
{
    become_user(order.uid);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        fail("PR_SET_NO_NEW_PRIVS");
    refuse_system_calls();
    set_limits(order);                               // last: from here on even our own memory is limited
    close_range(unsigned(order.ready) + 1, ~0u, 0);  // what bwrap has left open
    fcntl(order.ready, F_SETFD, FD_CLOEXEC);
    write_all(order.ready, "r", 1);
    execvp(order.command[0], order.command);
    int const error = errno;
    write_all(order.ready, "x", 1);
    errno = error;
    fail(order.command[0]);
}
}  // namespace
}  // namespace testat

int main(int argc, char** argv)
{
    if (argc < testat::Order::least_arguments) {
        std::fputs("confine: started by testat, not by hand\n", stderr);
        return 2;
    }
    try {
        testat::become(testat::Order(argv));
    } catch (std::exception const& e) {
        std::fprintf(stderr, "confine: %s\n", e.what());
        return 1;
    }
}
