// Each hole is shown open in a process without the restrictions and closed in one with them.
#include "probe/restrictions.h"

#include "process/run.h"
#include "sanitizers.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <system_error>

namespace testat {
namespace {
enum class Stage { free, loading, loading_with_threads, loaded };

std::filesystem::path this_program()
{
    return std::filesystem::read_symlink("/proc/self/exe");
}

/// Whether an attempt succeeds in a process of its own that has come so far.
bool works(Stage stage, std::function<bool()> const& attempt)
{
    Restrictions const restrictions(this_program());
    pid_t const pid = fork();
    if (pid == 0) {
        try {
            if (stage != Stage::free)
                restrictions.before_loading(stage == Stage::loading_with_threads);
            if (stage == Stage::loaded)
                restrictions.after_loading();
        } catch (std::system_error const&) {
            _exit(2);
        }
        _exit(attempt() ? 0 : 1);
    }
    int status = 0;
    waitpid(pid, &status, 0);
    EXPECT_TRUE(!WIFEXITED(status) || WEXITSTATUS(status) != 2) << "not restricted";
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

struct Hole {
    char const* name;
    bool (*attempt)();
};

bool sends_signal_with_high_bits()
{
    // The kernel takes the lower half of the argument, the filter must not take more.
    return syscall(SYS_tgkill, (1L << 32) | getppid(), long(getppid()), 0) == 0;
}

bool forks()
{
    pid_t const child = fork();
    if (child == 0)
        _exit(0);
    return child > 0;
}

bool reads_parent()
{
    char byte = 0;
    static char there = 1;
    iovec const local{&byte, 1}, remote{&there, 1};
    return process_vm_readv(getppid(), &local, 1, &remote, 1, 0) == 1;
}

/// From the beginning, constructors of the upload included.
Hole const holes[] = {
    {"ReadingFiles", [] { return open("/etc/passwd", O_RDONLY) >= 0; }},
    {"WritingFiles", [] { return open("/tmp", O_TMPFILE | O_RDWR, 0600) >= 0; }},
    {"Listing", [] { return open("/", O_RDONLY | O_DIRECTORY) >= 0; }},
    {"Forking", forks},
    {"Threads",
     [] {
         pthread_t t;
         return pthread_create(
                    &t, nullptr, [](void* p) { return p; }, nullptr) == 0;
     }},
    {"Sockets", [] { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
    {"SocketPairs",
     [] {
         int s[2];
         return socketpair(AF_UNIX, SOCK_STREAM, 0, s) == 0;
     }},
    {"SharedMemory",
     [] { return mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0) != MAP_FAILED; }},
    {"PagesWrittenOut",
     [] {
         static char page[1 << 16];
         return madvise(page, sizeof page, MADV_PAGEOUT) == 0 || errno != EPERM;
     }},
    {"MemoryFiles", [] { return memfd_create("x", 0) >= 0; }},
    {"Pipes",
     [] {
         int p[2];
         return pipe(p) == 0;
     }},
    {"SystemVMemory", [] { return shmctl(shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600), IPC_RMID, nullptr) == 0; }},
    {"Signals", [] { return kill(getppid(), 0) == 0; }},
    {"SignalsWithHighBits", sends_signal_with_high_bits},
    {"SignalsToAll", [] { return kill(-1, 0) == 0; }},
    {"Memory", reads_parent},
    {"Processes", [] { return syscall(SYS_pidfd_open, getppid(), 0) >= 0; }},
    {"Limits",
     [] {
         rlimit l{};
         return prlimit(getppid(), RLIMIT_CPU, nullptr, &l) == 0;
     }},
    {"Priorities", [] { return setpriority(PRIO_PROCESS, 0, 5) == 0; }},
    {"Prctl", [] { return prctl(PR_SET_NAME, "x") == 0; }},
    {"Alarms",
     [] {
         itimerval const later{{0, 0}, {100, 0}};
         return setitimer(ITIMER_REAL, &later, nullptr) == 0;
     }},
};

class RestrictedFrom : public testing::TestWithParam<Hole> {
protected:
    void SetUp() override
    {
        if (is_sanitized)
            GTEST_SKIP() << "sanitizers need more than the filters allow";
    }
};

TEST_P(RestrictedFrom, TheBeginning)
{
    EXPECT_TRUE(works(Stage::free, GetParam().attempt)) << "this says nothing here";
    EXPECT_FALSE(works(Stage::loading, GetParam().attempt));
    EXPECT_FALSE(works(Stage::loaded, GetParam().attempt));
}

INSTANTIATE_TEST_SUITE_P(Restrictions, RestrictedFrom, testing::ValuesIn(holes),
                         [](auto const& p) { return p.param.name; });

void* new_code()
{
    return mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
}

bool changes_code()
{
    auto const page = reinterpret_cast<std::uintptr_t>(&reads_parent) & ~std::uintptr_t(4095);
    return mprotect(reinterpret_cast<void*>(page), 4096, PROT_READ | PROT_WRITE | PROT_EXEC) == 0;
}

TEST(Restrictions, LeaveTheUploadAloneToBeLoaded)
{
    static std::string const path = this_program();
    auto const opens = [] { return open(path.c_str(), O_RDONLY) >= 0; };
    EXPECT_TRUE(works(Stage::loading, opens));
    EXPECT_EQ(works(Stage::loaded, opens), is_sanitized);
}

TEST(Restrictions, ForbidCodeThatIsInNoFile)
{
    for (bool (*attempt)() : {+[] { return new_code() != MAP_FAILED; }, changes_code}) {
        EXPECT_TRUE(works(Stage::free, attempt));
        EXPECT_EQ(works(Stage::loading, attempt), is_sanitized);
        EXPECT_EQ(works(Stage::loaded, attempt), is_sanitized);
    }
}

/// Only the descriptor that the loader opens next is an upload's.
TEST(Restrictions, ForbidCodeFromOtherFiles)
{
    static Descriptor const file = memory_file("code");
    ASSERT_EQ(ftruncate(file.get(), 4096), 0);
    static int const high = fcntl(file.get(), F_DUPFD, 20);
    auto const maps = [] { return mmap(nullptr, 4096, PROT_EXEC, MAP_PRIVATE, high, 0) != MAP_FAILED; };
    EXPECT_TRUE(works(Stage::free, maps));
    EXPECT_EQ(works(Stage::loading, maps), is_sanitized);
}

TEST(Restrictions, ForbidToMoveMemoryOverOther)
{
    auto const moves = [] {
        auto const page = [] { return mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0); };
        void* const there = page();
        return mremap(page(), 4096, 4096, MREMAP_MAYMOVE | MREMAP_FIXED, there) == there;
    };
    EXPECT_TRUE(works(Stage::free, moves));
    EXPECT_EQ(works(Stage::loading, moves), is_sanitized);
}

TEST(Restrictions, AllowThreadsToThoseWhoAskForThem)
{
    auto const starts = [] {
        pthread_t t;
        return pthread_create(
                   &t, nullptr, [](void* p) { return p; }, nullptr) == 0;
    };
    EXPECT_TRUE(works(Stage::loading_with_threads, starts));
    EXPECT_EQ(works(Stage::loading_with_threads, forks), is_sanitized);
}

TEST(Restrictions, AllowWhatComputingNeeds)
{
    auto const computes = [] {
        std::vector<double> many(1 << 22, 1.0);
        timespec const short_time{0, 1000};
        return many.back() == 1.0 && nanosleep(&short_time, nullptr) == 0 && write(STDOUT_FILENO, "", 0) == 0;
    };
    EXPECT_TRUE(works(Stage::loaded, computes));
}

TEST(Restrictions, LeaveAbortItsSignal)
{
    Restrictions const restrictions(this_program());
    pid_t const pid = fork();
    if (pid == 0) {
        restrictions.before_loading(false);
        restrictions.after_loading();
        std::abort();
    }
    int status = 0;
    waitpid(pid, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), SIGABRT);
}
}  // namespace
}  // namespace testat
