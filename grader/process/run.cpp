#include "process/run.h"

#include "process/tree.h"

#include <fcntl.h>
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
#include <cstdlib>
#include <system_error>

namespace testat {
namespace {
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupted = 0;

[[noreturn]] void fail(std::string const& what)
{
    throw std::system_error(errno, std::generic_category(), what);
}

void limit(int resource, rlim_t soft, rlim_t hard)
{
    rlimit const value{soft, hard};
    setrlimit(static_cast<__rlimit_resource>(resource), &value);
}

void apply_limits(Command const& command)
{
    limit(RLIMIT_CORE, 0, 0);
    if (command.cpu_s > 0) {
        auto const seconds = static_cast<rlim_t>(std::ceil(command.cpu_s));
        limit(RLIMIT_CPU, seconds, seconds + 1);
    }
    if (command.address_space > 0)
        limit(RLIMIT_AS, command.address_space, command.address_space);
    if (command.file_size > 0)
        limit(RLIMIT_FSIZE, command.file_size, command.file_size);
}

/// Moves the descriptors to their numbers, by way of numbers above them all so that none overwrites another, and
/// closes all others.
void place_descriptors(Command const& command, int output)
{
    int high = output + 1;
    for (auto const& pair : command.descriptors)
        high = std::max({high, pair.first + 1, pair.second + 1});
    std::vector<int> moved;
    for (auto const& pair : command.descriptors)
        moved.push_back(fcntl(pair.first, F_DUPFD, high));
    int const moved_output = fcntl(output, F_DUPFD, high);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(moved_output, STDOUT_FILENO);
    dup2(moved_output, STDERR_FILENO);
    close_range(3, unsigned(high) - 1, 0);
    for (std::size_t i = 0; i < moved.size(); ++i)
        dup2(moved[i], command.descriptors[i].second);
    close_range(unsigned(high), ~0u, 0);
}

[[noreturn]] void become(Command const& command, std::vector<char*> const& argv, std::vector<char*> const& environment,
                         int output)
{
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    signal(SIGPIPE, SIG_DFL);
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    if (chdir(command.directory.c_str()) != 0)
        _exit(127);
    place_descriptors(command, output);
    apply_limits(command);
    execve(argv[0], argv.data(), environment.data());
    _exit(127);
}

std::string find_program(std::string const& program)
{
    if (program.find('/') != std::string::npos)
        return access(program.c_str(), X_OK) == 0 ? program : "";
    for (char const* directory : {"/usr/local/bin/", "/usr/bin/", "/bin/"})
        if (access((directory + program).c_str(), X_OK) == 0)
            return directory + program;
    return "";
}

/// The minimal environment, less what the command says otherwise: getenv would find the first of two.
std::vector<std::string> environment_of(Command const& command)
{
    std::vector<std::string> all;
    for (std::string const variable :
         {"PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C.UTF-8", "HOME=/", "TMPDIR=/tmp"}) {
        std::string const start = variable.substr(0, variable.find('=') + 1);
        if (std::none_of(command.variables.begin(), command.variables.end(),
                         [&](std::string const& other) { return other.rfind(start, 0) == 0; }))
            all.push_back(variable);
    }
    all.insert(all.end(), command.variables.begin(), command.variables.end());
    return all;
}

/// As execve wants them, ended by null; they point into `texts`.
std::vector<char*> pointers(std::vector<std::string>& texts)
{
    std::vector<char*> all;
    for (auto& text : texts)
        all.push_back(text.data());
    all.push_back(nullptr);
    return all;
}

void keep_output(std::string& kept, char const* data, std::size_t size)
{
    kept.append(data, std::min(size, most_output - kept.size()));
}

/// What is in the pipe now; false once it is closed.
bool read_some(int pipe, std::string& output)
{
    char buffer[65536];
    ssize_t const got = read(pipe, buffer, sizeof buffer);
    if (got > 0)
        keep_output(output, buffer, static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && (errno == EINTR || errno == EAGAIN));
}

constexpr double look_again_s = 0.2;

/// How long to wait for something to happen, in ms, with `left_s` seconds to go (infinite without a limit). A signal
/// between the look at `interrupted` and the wait would else be lost until then.
int wait_ms(double left_s)
{
    return static_cast<int>(std::ceil(std::min(left_s, look_again_s) * 1000));
}

/// What is asked again and again while a program runs.
class Watch {
public:
    Watch(Command const& command, pid_t root) : command_(command), root_(root) {}

    double left_s() const { return command_.wall_s > 0 ? command_.wall_s - spent_s() : HUGE_VAL; }

    /// By the clock, less what the tree had to wait for a processor until the last look at it.
    double spent_s() const { return spent_s_ + seconds_since(last_look_); }

    /// Throws Interrupted on Ctrl-C.
    bool is_over()
    {
        if (interrupted && !command_.despite_interrupts)
            throw Interrupted();
        return left_s() <= 0 || tree_is_over();
    }

private:
    static double seconds_since(Clock::time_point then)
    {
        return std::chrono::duration<double>(Clock::now() - then).count();
    }

    /// A program that prints without end must not make us read /proc without end.
    bool tree_is_over()
    {
        if (seconds_since(last_look_) < look_again_s || (command_.tree_cpu_s <= 0 && command_.tree_memory == 0))
            return false;
        TreeUsage const usage = usage_of_tree(root_);
        count_time(usage);
        return (command_.tree_cpu_s > 0 && usage.cpu_s > command_.tree_cpu_s) ||
               (command_.tree_memory > 0 && usage.memory > command_.tree_memory);
    }

    /// While several wait it is their time once.
    void count_time(TreeUsage const& usage)
    {
        double waited_s = 0;
        for (auto const& [process, all_s] : usage.waited_s)
            waited_s += std::max(0., all_s - waited_s_[process]);
        double const passed_s = seconds_since(last_look_);
        spent_s_ += passed_s - std::min(waited_s, passed_s);
        last_look_ = Clock::now();
        waited_s_ = usage.waited_s;
    }

    Command const& command_;
    pid_t root_;
    Clock::time_point last_look_ = Clock::now();
    double spent_s_ = 0;
    std::map<pid_t, double> waited_s_;
};

/// Collects output until the child has ended or used up a limit; true if it has. What others who hold the pipe write
/// later is not waited for.
bool attend(int child, int pipe, Watch& watch, std::string& output)
{
    pollfd events[] = {{child, POLLIN, 0}, {pipe, POLLIN, 0}};
    for (;;) {
        if (watch.is_over())
            return true;
        if (poll(events, 2, wait_ms(watch.left_s())) < 0) {
            if (errno != EINTR)
                fail("waiting for a child process");
            continue;
        }
        if (events[1].revents != 0 && !read_some(pipe, output))
            events[1].fd = -1;
        else if (events[0].revents != 0 && events[1].revents == 0)
            return false;
        events[1].revents = 0;
    }
}

/// Kills the process group of a child and reaps the child, whatever happens in between.
class Child {
public:
    explicit Child(pid_t pid) : pid_(pid) {}
    ~Child()
    {
        if (pid_ > 0)
            end();
    }
    Child(Child const&) = delete;
    Child& operator=(Child const&) = delete;

    Finished end(bool kill_first = true)
    {
        if (kill_first)
            kill(-pid_, SIGKILL);
        int status = 0;
        rusage usage{};
        while (wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR && !interrupted) {
        }
        kill(-pid_, SIGKILL);
        pid_ = -1;
        Finished finished;
        if (WIFEXITED(status))
            finished.exit_code = WEXITSTATUS(status);
        if (WIFSIGNALED(status))
            finished.signal = WTERMSIG(status);
        finished.cpu_s = cpu_seconds(usage);
        return finished;
    }

private:
    pid_t pid_;
};
}  // namespace

void catch_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = 1; };
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

void wait_for(double seconds)
{
    auto const end = Clock::now() + std::chrono::duration<double>(seconds);
    for (double left_s = seconds; left_s > 0; left_s = std::chrono::duration<double>(end - Clock::now()).count()) {
        if (interrupted)
            throw Interrupted();
        poll(nullptr, 0, wait_ms(left_s));
    }
}

bool is_in_path(std::string const& program)
{
    return !find_program(program).empty();
}

Finished run(Command const& command)
{
    std::string const program = find_program(command.argv.at(0));
    if (program.empty())
        throw std::runtime_error("cannot run '" + command.argv[0] + "': it is not installed");
    std::vector<std::string> arguments = command.argv;
    arguments[0] = program;
    std::vector<std::string> variables = environment_of(command);
    auto const argv = pointers(arguments);
    auto const environment = pointers(variables);

    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        fail("pipe for " + program);
    Descriptor read_end(ends[0]);
    Descriptor write_end(ends[1]);
    pid_t const pid = fork();
    if (pid < 0)
        fail("fork for " + program);
    if (pid == 0)
        become(command, argv, environment, write_end.get());
    Child child(pid);
    write_end.reset();

    std::string output;
    Descriptor const handle(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
    if (handle.get() < 0)
        fail("pidfd_open for " + program);
    Watch watch(command, pid);
    bool const late = attend(handle.get(), read_end.get(), watch, output);
    Finished finished = child.end(late);
    finished.output = std::move(output);
    finished.wall_s = watch.spent_s();
    finished.timed_out = late || finished.signal == SIGXCPU ||
                         (command.cpu_s > 0 && finished.signal == SIGKILL && finished.cpu_s >= command.cpu_s);
    if (finished.exit_code == 127 && finished.output.empty())
        throw std::runtime_error("cannot run '" + program + "' in " + command.directory.string());
    return finished;
}

TemporaryDirectory::TemporaryDirectory(std::filesystem::path const& parent)
{
    std::string pattern = (parent / "testat-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
        fail("temporary directory " + pattern);
    path_ = pattern;
}

TemporaryDirectory::~TemporaryDirectory()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void Descriptor::reset()
{
    if (fd_ >= 0)
        close(fd_);
    fd_ = -1;
}

void write_all(int fd, void const* data, std::size_t size)
{
    auto const* at = static_cast<char const*>(data);
    while (size > 0) {
        ssize_t const written = write(fd, at, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            fail("writing");
        at += written;
        size -= static_cast<std::size_t>(written);
    }
}

double cpu_seconds(rusage const& usage)
{
    auto const seconds = [](timeval t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Descriptor memory_file(char const* name)
{
    Descriptor file(memfd_create(name, MFD_CLOEXEC));
    if (file.get() < 0)
        fail(std::string("memory file ") + name);
    return file;
}
}  // namespace testat
