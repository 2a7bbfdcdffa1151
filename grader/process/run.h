#pragma once
#include <sys/resource.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace testat {
/// A program to run to its end, with limits. Zero means no limit.
struct Command {
    std::vector<std::string> argv;  ///< argv[0] is looked up in PATH unless it contains a slash
    std::filesystem::path directory = "/";
    std::vector<std::pair<int, int>> descriptors;  ///< {ours, theirs}; stdin, stdout and stderr are taken care of
    double cpu_s = 0;                              ///< for each process; the kernel enforces it
    double wall_s = 0;                             ///< see Finished
    std::size_t address_space = 0;                 ///< bytes, for each process; the kernel enforces it
    std::size_t file_size = 0;                     ///< bytes, for each file; the kernel enforces it
    double tree_cpu_s = 0;                    ///< for the program and all that it starts; looked at five times a second
    std::size_t tree_memory = 0;              ///< bytes, likewise
    std::vector<std::string> variables = {};  ///< "NAME=value", besides the minimal environment or instead of it
    bool despite_interrupts = false;          ///< runs to its end though Ctrl-C has arrived: what tidies up
};

/// What is kept of a program's output, in bytes.
constexpr std::size_t most_output = 1 << 20;

/// How it ended. Whether that is somebody's fault is for the caller to say.
struct Finished {
    int exit_code = -1;  ///< -1 when a signal ended it
    int signal = 0;
    bool timed_out = false;  ///< a limit on time, or on the memory of all processes together
    std::string output;      ///< the first `most_output` bytes of stdout and stderr together
    double cpu_s = 0;
    double wall_s = 0;  ///< by the clock, less what its processes had to wait for a processor
};

/// Ctrl-C or SIGTERM arrived; everything started so far is gone when this is caught.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Makes SIGINT and SIGTERM end `run` with Interrupted instead of ending the program.
void catch_interrupts();

/// Runs a command in a session of its own with a minimal environment, and waits; its whole process group is killed
/// at the end. Throws std::runtime_error if the program cannot be started, Interrupted on Ctrl-C.
Finished run(Command const& command);

/// Waits. Throws Interrupted on Ctrl-C.
void wait_for(double seconds);

/// Whether a program of that name is in PATH and executable.
bool is_in_path(std::string const& program);

/// A new directory below another one, removed with everything in it at the end of its life.
class TemporaryDirectory {
public:
    explicit TemporaryDirectory(std::filesystem::path const& parent = std::filesystem::temp_directory_path());
    ~TemporaryDirectory();
    TemporaryDirectory(TemporaryDirectory const&) = delete;
    TemporaryDirectory& operator=(TemporaryDirectory const&) = delete;
    std::filesystem::path const& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(fd_, other.fd_);
        return *this;
    }
    ~Descriptor() { reset(); }
    int get() const { return fd_; }
    void reset();

private:
    int fd_;
};

/// Writes everything, however many calls that takes. Throws std::system_error.
void write_all(int fd, void const* data, std::size_t size);

/// User and system time together.
double cpu_seconds(rusage const& usage);

/// An anonymous file in memory, closed on exec. Throws std::system_error.
Descriptor memory_file(char const* name);
}  // namespace testat
