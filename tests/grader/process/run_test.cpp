#include "process/run.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace testat {
namespace {
Command program(std::vector<std::string> const& argv)
{
    Command command;
    command.argv = argv;
    return command;
}

Command shell(std::string const& script)
{
    return program({"sh", "-c", script});
}

/// A pipe that tells whether anybody has its other end.
struct Pipe {
    Pipe()
    {
        int ends[2];
        EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
        read_end = Descriptor(ends[0]);
        write_end = Descriptor(ends[1]);
    }
    bool is_closed() const
    {
        pollfd p{read_end.get(), POLLIN, 0};
        return poll(&p, 1, 10'000) == 1 && (p.revents & POLLHUP) != 0;
    }
    Descriptor read_end;
    Descriptor write_end;
};

bool is_open(int fd)
{
    return std::filesystem::exists("/proc/self/fd/" + std::to_string(fd));
}
}  // namespace

TEST(Run, GivesTheExitCode)
{
    Finished const finished = run(shell("exit 3"));
    EXPECT_EQ(finished.exit_code, 3);
    EXPECT_EQ(finished.signal, 0);
    EXPECT_FALSE(finished.timed_out);
}

TEST(Run, GivesTheSignal)
{
    Finished const finished = run(shell("kill -SEGV $$"));
    EXPECT_EQ(finished.exit_code, -1);
    EXPECT_EQ(finished.signal, SIGSEGV);
    EXPECT_FALSE(finished.timed_out);
}

TEST(Run, CapturesBothOutputs)
{
    EXPECT_EQ(run(shell("echo out; echo err >&2")).output, "out\nerr\n");
}

TEST(Run, KeepsTheFirstMegabyte)
{
    Finished const finished = run(shell("printf first; head -c 3000000 /dev/zero; exit 5"));
    EXPECT_EQ(finished.output.size(), 1u << 20);
    EXPECT_EQ(finished.output.substr(0, 5), "first");
    EXPECT_EQ(finished.exit_code, 5);
}

TEST(Run, EndsAtTheWallLimit)
{
    Command command = shell("echo before; sleep 100");
    command.wall_s = 0.2;
    Finished const finished = run(command);
    EXPECT_TRUE(finished.timed_out);
    EXPECT_EQ(finished.output, "before\n");
}

TEST(Run, EndsAtTheCpuLimit)
{
    Command command = shell("while :; do :; done");
    command.cpu_s = 1;
    command.wall_s = 60;
    EXPECT_TRUE(run(command).timed_out);
}

TEST(Run, EndsAtTheCpuLimitOfAllProcesses)
{
    // Each of them alone would compute for ever.
    Command command = shell("for i in 1 2 3 4; do (while :; do :; done) & done; wait");
    command.tree_cpu_s = 1;
    EXPECT_TRUE(run(command).timed_out);
    command = shell("while :; do /usr/bin/true; done");
    command.tree_cpu_s = 1;
    EXPECT_TRUE(run(command).timed_out);
}

TEST(Run, EndsAtTheMemoryLimitOfAllProcesses)
{
    // The text and what it was made from.
    std::string const takes_120_mb = "perl -e '$x = \"x\" x 60000000; sleep $ARGV[0]' ";
    Command command = shell(takes_120_mb + "1");
    command.tree_memory = 200 << 20;
    EXPECT_FALSE(run(command).timed_out);
    command = shell(takes_120_mb + "100 & " + takes_120_mb + "100");
    command.tree_memory = 200 << 20;
    EXPECT_TRUE(run(command).timed_out);
}

TEST(Run, LimitsMemoryAndFiles)
{
    TemporaryDirectory const directory;
    Command command = shell("head -c 100000 /dev/zero > large");
    command.directory = directory.path();
    command.file_size = 1000;
    EXPECT_NE(run(command).exit_code, 0);
    EXPECT_LE(std::filesystem::file_size(directory.path() / "large"), 1000u);
    command = shell("ulimit -v");
    command.address_space = 1 << 30;
    EXPECT_EQ(run(command).output, "1048576\n");
}

TEST(Run, KillsWhatTheProgramHasStarted)
{
    Pipe pipe;
    Command command = shell("sleep 100 > /dev/null 2>&1 &");
    command.descriptors = {{pipe.write_end.get(), 3}};
    run(command);
    pipe.write_end.reset();
    EXPECT_TRUE(pipe.is_closed()) << "somebody still holds it";
}

TEST(Run, KeepsTheWallLimitOfAProgramThatClosesItsOutput)
{
    Command command = shell("exec > /dev/null 2>&1; sleep 30");
    command.wall_s = 0.2;
    EXPECT_TRUE(run(command).timed_out);
}

TEST(Run, EndsWithTheProgramWhoeverHoldsItsOutput)
{
    Command command = shell("echo done; sleep 30 & exit 5");
    command.wall_s = 10;
    Finished const finished = run(command);
    EXPECT_EQ(finished.exit_code, 5);
    EXPECT_EQ(finished.output, "done\n");
    EXPECT_FALSE(finished.timed_out);
}

TEST(Run, ThrowsIfThereIsNoSuchProgram)
{
    EXPECT_THROW(run(program({"no-such-program"})), std::runtime_error);
    EXPECT_THROW(run(program({"/no/such/program"})), std::runtime_error);
}

TEST(Run, ThrowsIfThereIsNoSuchDirectory)
{
    Command command = shell("true");
    command.directory = "/no/such/directory";
    EXPECT_THROW(run(command), std::runtime_error);
}

TEST(Run, RunsInTheDirectory)
{
    TemporaryDirectory const directory;
    Command command = shell("pwd");
    command.directory = directory.path();
    EXPECT_EQ(run(command).output, directory.path().string() + "\n");
}

TEST(Run, PassesDescriptors)
{
    Descriptor const a = memory_file("a");
    Descriptor const b = memory_file("b");
    Command command = shell("echo to a >&4; echo to b >&3");
    command.descriptors = {{a.get(), 4}, {b.get(), 3}};
    EXPECT_EQ(run(command).exit_code, 0);
    char text[6] = {};
    EXPECT_EQ(pread(a.get(), text, 5, 0), 5);
    EXPECT_STREQ(text, "to a\n");
    EXPECT_EQ(pread(b.get(), text, 5, 0), 5);
    EXPECT_STREQ(text, "to b\n");
}

TEST(Run, PassesDescriptorsWhateverTheirNumbers)
{
    std::vector<Descriptor> many;
    for (int last = 0; last < 110; last = many.back().get()) {
        many.emplace_back(dup(STDIN_FILENO));
        Descriptor const file = memory_file("file");
        Command command = shell("echo file >&3; echo output");
        command.descriptors = {{file.get(), 3}};
        char text[6] = {};
        EXPECT_EQ(run(command).output, "output\n") << "file is " << file.get();
        EXPECT_EQ(pread(file.get(), text, 5, 0), 5) << "file is " << file.get();
    }
}

TEST(Run, WorksWhereDescriptorsAreScarce)
{
    rlimit usual{};
    getrlimit(RLIMIT_NOFILE, &usual);
    rlimit const scarce{256, usual.rlim_max};
    setrlimit(RLIMIT_NOFILE, &scarce);
    std::string const output = run(shell("echo output")).output;
    setrlimit(RLIMIT_NOFILE, &usual);
    EXPECT_EQ(output, "output\n");
}

TEST(Run, PassesNoOtherDescriptors)
{
    int const leaked = dup(STDIN_FILENO);
    EXPECT_EQ(run(shell("ls /proc/self/fd | sort -n | tr '\\n' ' '")).output.substr(0, 6), "0 1 2 ");
    EXPECT_EQ(run(shell("test -e /proc/self/fd/" + std::to_string(leaked))).exit_code, 1);
    close(leaked);
}

TEST(Run, ReadsNothingFromOurInput)
{
    EXPECT_EQ(run(shell("cat")).output, "");
}

TEST(Run, HasAMinimalEnvironment)
{
    setenv("TESTAT_SECRET", "1", 1);
    EXPECT_EQ(run(program({"env"})).output, "PATH=/usr/local/bin:/usr/bin:/bin\nLC_ALL=C.UTF-8\nHOME=/\nTMPDIR=/tmp\n");
    unsetenv("TESTAT_SECRET");
}

TEST(Run, AddsVariablesToTheEnvironment)
{
    Command command = program({"env"});
    command.variables = {"TESTAT_A=1", "TESTAT_B=x y"};
    EXPECT_NE(run(command).output.find("TMPDIR=/tmp\nTESTAT_A=1\nTESTAT_B=x y\n"), std::string::npos);
}

TEST(Run, HasEachVariableOnce)
{
    Command command = program({"env"});
    command.variables = {"TMPDIR=/elsewhere"};
    EXPECT_EQ(run(command).output, "PATH=/usr/local/bin:/usr/bin:/bin\nLC_ALL=C.UTF-8\nHOME=/\nTMPDIR=/elsewhere\n");
}

TEST(Run, CountsCpuTime)
{
    EXPECT_GT(run(shell("i=0; while [ $i -lt 20000 ]; do i=$((i+1)); done")).cpu_s, 0);
}

TEST(IsInPath, LooksWhereRunLooks)
{
    EXPECT_TRUE(is_in_path("sh"));
    EXPECT_FALSE(is_in_path("no-such-program"));
    EXPECT_FALSE(is_in_path("/no/such/program"));
}

TEST(TemporaryDirectory, IsRemovedWithEverythingInIt)
{
    std::filesystem::path path;
    {
        TemporaryDirectory const directory;
        path = directory.path();
        std::filesystem::create_directories(path / "a" / "b");
        std::ofstream(path / "a" / "file") << "x";
        EXPECT_TRUE(std::filesystem::is_directory(path));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TemporaryDirectory, IsNew)
{
    TemporaryDirectory const a, b;
    EXPECT_NE(a.path(), b.path());
}

TEST(Descriptor, ClosesItself)
{
    int fd = -1;
    {
        Descriptor const file = memory_file("x");
        fd = file.get();
        EXPECT_TRUE(is_open(fd));
    }
    EXPECT_FALSE(is_open(fd));
}

TEST(Descriptor, HasOneOwner)
{
    Descriptor a = memory_file("x");
    int const fd = a.get();
    Descriptor b(std::move(a));
    EXPECT_EQ(b.get(), fd);
    EXPECT_TRUE(is_open(fd));
    b.reset();
    EXPECT_FALSE(is_open(fd));
}
}  // namespace testat
