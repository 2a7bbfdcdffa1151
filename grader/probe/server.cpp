#include "probe/server.h"

#include "probe/accounts.h"
#include "probe/child.h"
#include "probe/fair_time.h"
#include "process/run.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <system_error>
#include <vector>

// How a group is answered. The server forks a child for each group; the child loads the libraries, fills the slots
// and writes into the blackboard, memory that both share. The server waits with a CPU limit (kernel) and a wall limit
// (here), kills what is left of the child's session, copies the blackboard to the answer stream and wipes it. A child
// therefore sees no other group's answers, and what it does to itself reaches the stream only as values.
namespace testat {
namespace {
[[noreturn]] void fail(char const* what)
{
    throw std::system_error(errno, std::generic_category(), what);
}

double now_s()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// CPU seconds of a process, all threads together.
double cpu_seconds_of(pid_t pid)
{
    clockid_t clock;
    timespec time{};
    if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0)
        return 0;
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Waits for a child, looking at it five times a second.
class Wait {
public:
    explicit Wait(pid_t pid) : pid_(pid), handle_(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)))
    {
        if (handle_.get() < 0)
            fail("pidfd_open");
    }

    /// Until it has ended or so much time has passed, in fairness; true if it has passed.
    bool is_late(double wall_s)
    {
        while (time_.spent_s() < wall_s)
            if (has_ended(std::min(wall_s - time_.spent_s(), look_again_s)))
                return false;
        return true;
    }

    double spent_s() const { return time_.spent_s(); }

private:
    static constexpr double look_again_s = 0.2;

    bool has_ended(double within_s)
    {
        double const start_s = now_s();
        pollfd p{handle_.get(), POLLIN, 0};
        int const ready = poll(&p, 1, static_cast<int>(std::ceil(within_s * 1000)));
        double const cpu_s = ready == 1 ? HUGE_VAL : cpu_seconds_of(pid_);
        time_.pass(now_s() - start_s, cpu_s - cpu_s_);
        cpu_s_ = cpu_s;
        return ready == 1;
    }

    pid_t pid_;
    Descriptor handle_;
    FairTime time_;
    double cpu_s_ = 0;
};

/// Ends whatever the child has left behind and collects the dead.
void sweep(pid_t session)
{
    kill(-session, SIGKILL);
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
}

struct Death {
    int status = 0;
    double cpu_s = 0;
    double wall_s = 0;
    bool late = false;
};

Death await_death(pid_t pid, double limit_s)
{
    Death death;
    Wait wait(pid);
    death.late = wait.is_late(Accounts::wall_limit(limit_s));
    death.wall_s = wait.spent_s();
    if (death.late)
        kill(-pid, SIGKILL);
    rusage usage{};
    while (wait4(pid, &death.status, 0, &usage) < 0 && errno == EINTR) {
    }
    death.cpu_s = cpu_seconds(usage);
    sweep(pid);
    return death;
}

Ended classify(Death const& death, Blackboard const& board, double limit_s)
{
    bool const out_of_cpu =
        WIFSIGNALED(death.status) &&
        (WTERMSIG(death.status) == SIGXCPU || (WTERMSIG(death.status) == SIGKILL && death.cpu_s >= limit_s));
    if (death.late || out_of_cpu)
        return Ended::timed_out;
    if (WIFSIGNALED(death.status))
        return Ended::signal;
    if (board.phase == Phase::threw)
        return Ended::exception;
    if (board.phase == Phase::not_loaded)
        return Ended::not_loaded;
    return board.phase == Phase::done ? Ended::answered : Ended::exit;
}

GroupStatus describe(Death const& death, Blackboard const& board, double limit_s)
{
    GroupStatus status;
    status.ended = classify(death, board, limit_s);
    status.code = WIFSIGNALED(death.status) ? WTERMSIG(death.status) : WEXITSTATUS(death.status);
    status.answered = board.answered;
    status.wrote = board.wrote;
    status.cpu_s = death.cpu_s;
    status.work_s = board.work_s;
    status.kept = board.kept;
    status.pass_s = board.pass_s;
    std::copy(std::begin(board.text), std::end(board.text), status.text);
    return status;
}

void read_output(Descriptor const& output, GroupStatus& status)
{
    off_t const size = lseek(output.get(), 0, SEEK_END);
    status.printed = static_cast<std::uint32_t>(std::max<off_t>(size, 0));
    if (pread(output.get(), status.output, sizeof status.output, 0) < 0)
        status.output[0] = 0;
}

/// The blackboard's mapping, large enough for the largest group.
class SharedBoard {
public:
    /// Whole pages: a child could write to the rest of the last one, too.
    explicit SharedBoard(std::size_t words) : size_((sizeof(Blackboard) + 4 * words + page - 1) / page * page)
    {
        memory_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory_ == MAP_FAILED)
            fail("shared memory for answers");
    }
    ~SharedBoard() { munmap(memory_, size_); }
    SharedBoard(SharedBoard const&) = delete;
    SharedBoard& operator=(SharedBoard const&) = delete;

    /// All of it, also where this group has no answers: nothing passes from one child to another.
    void wipe(std::size_t words)
    {
        std::memset(memory_, 0, size_);
        board() = Blackboard{};
        std::fill_n(answers(), words, unanswered);
    }
    Blackboard& board() const { return *static_cast<Blackboard*>(memory_); }
    std::uint32_t* answers() const { return reinterpret_cast<std::uint32_t*>(&board() + 1); }

private:
    static constexpr std::size_t page = 4096;

    std::size_t size_;
    void* memory_;
};

class Server {
public:
    Server(Request const& request, Libraries const& libraries, AssetLibrary& assets)
        : request_(request),
          libraries_(libraries),
          assets_(assets),
          restrictions_(libraries.upload),
          board_(largest(request)),
          accounts_(request.limits, request.hanging)
    {
        if (!can_be_restricted(restrictions_))
            throw std::runtime_error("this machine does not let a process be restricted");
    }

    void answer_group(Group const& group, int answers)
    {
        board_.wipe(group.answer_size());
        double const limit_s = loading_hangs_ ? 0 : accounts_.limit_for(group.from_upload, elapsed_s_);
        GroupStatus const status = limit_s > 0 ? run(group, limit_s) : out_of_time();
        write_all(answers, &status, sizeof status);
        write_all(answers, board_.answers(), 4 * group.answer_size());
    }

private:
    static std::size_t largest(Request const& request)
    {
        std::size_t words = 0;
        for (auto const& group : request.groups)
            words = std::max(words, group.answer_size());
        return words;
    }

    static GroupStatus out_of_time()
    {
        GroupStatus status;
        status.ended = Ended::timed_out;
        return status;
    }

    GroupStatus run(Group const& group, double limit_s)
    {
        Descriptor const output = memory_file("output");
        pid_t const pid = fork();
        if (pid < 0)
            fail("fork");
        if (pid == 0)
            become_child({group, request_.textures, assets_, libraries_, restrictions_, limit_s, output.get(),
                          board_.board(), board_.answers()});
        Death const death = await_death(pid, limit_s);
        GroupStatus status = describe(death, board_.board(), limit_s);
        read_output(output, status);
        bool const late = status.ended == Ended::timed_out;
        elapsed_s_ += death.wall_s;
        accounts_.charge(group.from_upload, status.cpu_s, death.wall_s, late);
        loading_hangs_ = loading_hangs_ || (late && board_.board().phase == Phase::loading);
        return status;
    }

    Request const& request_;
    Libraries const& libraries_;
    AssetLibrary& assets_;
    Restrictions const restrictions_;
    SharedBoard board_;
    double elapsed_s_ = 0;  ///< of the children, in fairness
    Accounts accounts_;
    bool loading_hangs_ = false;
};
}  // namespace

void serve(Request const& request, Libraries const& libraries, AssetLibrary& assets, int answers)
{
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    assets.map_texels();
    Server server(request, libraries, assets);
    write_all(answers, &greeting, sizeof greeting);
    for (auto const& group : request.groups)
        server.answer_group(group, answers);
}
}  // namespace testat
