#include "sandbox/cage.h"

#include "sandbox/system_calls.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace testat {
namespace {
Caged shell(std::string const& script)
{
    Caged caged;
    caged.command.argv = {"sh", "-c", script};
    caged.command.wall_s = 30;
    caged.command.cpu_s = 10;
    caged.sees = compiler_directories();
    return caged;
}

Finished run_in(Confinement confinement, Caged const& caged)
{
    Cage cage(confinement);
    return cage.run(caged);
}

Finished run_caged(Caged const& caged)
{
    return run_in(Confinement::cage, caged);
}

/// A script that gets through where there is no wall.
struct Wall {
    char const* name;
    char const* script;
};

Wall const walls[] = {
    {"HostFiles", "cat /etc/passwd"},
    {"OurFiles", "cat " TESTAT_REPOSITORY "/references/rubric.json"},
    {"Processes", "test $(ls -d /proc/[0-9]* | wc -l) -gt 9"},
    {"Devices", "head -c 1 /dev/zero"},
    {"SharedMemory", "ls /dev/shm"},
    {"TemporaryFiles", "mktemp -u && f=$(mktemp) && rm $f"},
    {"ManyProcesses", "for i in $(seq 50); do sleep 2 & done"},
    {"ManyFiles", "ulimit -n 1000"},
    {"LockedMemory", "test $(ulimit -l) != 0"},
};

class CageWall : public testing::TestWithParam<Wall> {};

TEST_P(CageWall, Stands)
{
    EXPECT_EQ(run_in(Confinement::none, shell(GetParam().script)).exit_code, 0) << "this says nothing here";
    EXPECT_NE(run_caged(shell(GetParam().script)).exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(Cage, CageWall, testing::ValuesIn(walls), [](auto const& p) { return p.param.name; });

/// Tells whether anybody still has its other end.
struct Pipe {
    Pipe()
    {
        int ends[2];
        EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
        read_end = Descriptor(ends[0]);
        write_end = Descriptor(ends[1]);
    }
    bool is_closed()
    {
        write_end.reset();
        pollfd p{read_end.get(), POLLIN, 0};
        return poll(&p, 1, 10'000) == 1 && (p.revents & POLLHUP) != 0;
    }
    Descriptor read_end;
    Descriptor write_end;
};
}  // namespace

TEST(Cage, GivesExitCodeAndOutput)
{
    Finished const finished = run_caged(shell("echo here; exit 3"));
    EXPECT_EQ(finished.exit_code, 3);
    EXPECT_EQ(finished.output, "here\n");
}

TEST(Cage, GivesTheSignal)
{
    Finished const finished = run_caged(shell("kill -SEGV $$"));
    EXPECT_EQ(finished.signal, SIGSEGV);
    EXPECT_FALSE(finished.timed_out);
}

TEST(Cage, StopsWhatComputesTooLong)
{
    Caged caged = shell("while :; do :; done");
    caged.command.cpu_s = 1;
    EXPECT_TRUE(run_caged(caged).timed_out);
}

TEST(Cage, StopsWhatSleepsTooLong)
{
    Caged caged = shell("sleep 1000");
    caged.command.wall_s = 0.3;
    EXPECT_TRUE(run_caged(caged).timed_out);
}

TEST(Cage, LeavesNoProcessBehind)
{
    for (char const* script : {"setsid sleep 1000 & exit 0", "setsid sleep 1000 & sleep 1000"}) {
        Pipe pipe;
        Caged caged = shell(script);
        caged.command.wall_s = 0.5;
        caged.command.descriptors = {{pipe.write_end.get(), 5}};
        run_caged(caged);
        EXPECT_TRUE(pipe.is_closed()) << script;
    }
}

TEST(Cage, LimitsMemoryAndFiles)
{
    TemporaryDirectory const place;
    std::string const big = place.path() / "big";
    Caged caged =
        shell("head -c 10000 /usr/bin/bash > " + big + "; test $(stat -c %s " + big + ") -le 4096 && ulimit -v");
    caged.command.address_space = std::size_t(1) << 30;
    caged.command.file_size = 4096;
    caged.writes = place.path();
    Cage cage(Confinement::cage);
    cage.hand_over(place.path());
    std::string const output = cage.run(caged).output;
    EXPECT_NE(output.find("1048576"), std::string::npos) << output;
}

TEST(Cage, HasTemporaryFilesWhereTheyAreAskedFor)
{
    Caged caged = shell("f=$(mktemp) && echo x > $f && ! head -c 300000000 /usr/bin/* > $f");
    caged.temporary_files = true;
    EXPECT_EQ(run_caged(caged).exit_code, 0);
}

TEST(Cage, IsReadOnly)
{
    Finished const finished = run_caged(shell("touch /x /dev/x /usr/x /usr/lib/x /usr/bin/x"));
    EXPECT_NE(finished.exit_code, 0);
    for (char const* path : {"/x'", "/dev/x'", "/usr/x'", "/usr/lib/x'", "/usr/bin/x'"})
        EXPECT_NE(finished.output.find("'" + std::string(path)), std::string::npos) << finished.output;
}

TEST(Cage, ShowsWhatWasShown)
{
    TemporaryDirectory const place;
    Caged caged = shell("ls " + place.path().string());
    caged.sees.push_back(place.path());
    Cage cage(Confinement::cage);
    cage.show(place.path());
    EXPECT_EQ(cage.run(caged).exit_code, 0);
}

TEST(Cage, IsForAUserOfItsOwn)
{
    std::string const user = run_caged(shell("id -u")).output;
    if (geteuid() == 0)
        EXPECT_GE(std::stoul(user), first_slot_uid);
    else
        EXPECT_EQ(std::stoul(user), geteuid());
}

/// What is left of root must not come back.
TEST(Cage, HasNoCapabilities)
{
    EXPECT_NE(run_caged(shell("chown 1 /dev/null")).exit_code, 0);
    EXPECT_NE(run_caged(shell("unshare --mount true")).exit_code, 0);
    EXPECT_NE(run_caged(shell("unshare --user true")).exit_code, 0);
    EXPECT_NE(run_caged(shell("setpriv --reuid 0 true")).exit_code, 0);
}

TEST(Cage, KeepsAnAllowanceOfCpuTime)
{
    Cage cage(Confinement::cage, {1, 60});
    EXPECT_TRUE(cage.run(shell("while :; do :; done")).timed_out);
    Finished const next = cage.run(shell("echo here"));
    EXPECT_TRUE(next.timed_out);
    EXPECT_EQ(next.output, "");
}

/// The kernel's limit would let each of them have it.
TEST(Cage, KeepsAnAllowanceOfCpuTimeWhileManyCompute)
{
    Cage cage(Confinement::cage, {2, 60});
    EXPECT_TRUE(cage.run(shell("for i in 1 2 3 4 5 6; do (while :; do :; done) & done; wait")).timed_out);
    EXPECT_GT(cage.left().cpu_s, -5);
}

TEST(Cage, KeepsAnAllowanceOfMemory)
{
    std::string const takes_120_mb = "perl -e '$x = \"x\" x 60000000; sleep 100' ";
    Cage cage(Confinement::cage, {60, 30, 200 << 20});
    EXPECT_TRUE(cage.run(shell(takes_120_mb + "& " + takes_120_mb)).timed_out);
    EXPECT_GT(cage.left().wall_s, 1) << "it was the clock that ended them";
}

TEST(Cage, KeepsAnAllowanceOfWallTime)
{
    Cage cage(Confinement::cage, {60, 0.3});
    EXPECT_TRUE(cage.run(shell("sleep 1000")).timed_out);
    EXPECT_TRUE(cage.run(shell("echo here")).timed_out);
}

TEST(Cage, SaysThatAProgramIsMissing)
{
    Caged caged = shell("");
    caged.command.argv = {"no-such-program"};
    EXPECT_THROW(run_caged(caged), std::runtime_error);
}

TEST(Cage, SaysThatItCannotBePutUp)
{
    Caged caged = shell("exit 0");
    caged.command.directory = "/no/such/directory";
    try {
        run_caged(caged);
        FAIL() << "it was put up";
    } catch (std::runtime_error const& e) {
        EXPECT_NE(std::string(e.what()).find("could not be put up"), std::string::npos) << e.what();
    }
}

/// What runs inside may print what it likes and end as it likes: that is not our fault.
TEST(Cage, IsNotFooledByItsProgram)
{
    Finished const finished = run_caged(shell("echo 'bwrap: setting up failed' >&2; echo r >&9; exit 1"));
    EXPECT_EQ(finished.exit_code, 1);
}

TEST(Slots, AreDifferentUsers)
{
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can be others";
    Slot const one;
    Slot const two;
    EXPECT_NE(one.uid(), two.uid());
    EXPECT_GE(one.uid(), first_slot_uid);
    EXPECT_LT(two.uid(), first_slot_uid + slots);
}

TEST(CageTrouble, IsNoneWhereTheseTestsRun)
{
    EXPECT_EQ(find_cage_trouble().problem, "");
}

/// The problem and its remedy as they are where the kernel does not know these calls.
std::string trouble_without(std::vector<int> const& calls, std::vector<scmp_arg_cmp> const& conditions = {})
{
    Descriptor const words = memory_file("trouble");
    pid_t const pid = fork();
    if (pid == 0) {
        SystemCallFilter filter(SCMP_ACT_ALLOW);
        filter.add(SCMP_ACT_ERRNO(ENOSYS), calls, conditions);
        filter.load();
        CageTrouble const trouble = find_cage_trouble();
        std::string const text = trouble.problem + "; " + trouble.remedy;
        write_all(words.get(), text.data(), text.size());
        _exit(0);
    }
    waitpid(pid, nullptr, 0);
    char text[1000] = {};
    EXPECT_GT(pread(words.get(), text, sizeof text - 1, 0), 0);
    return text;
}

TEST(CageTrouble, NamesWhatTheKernelLacksAndWhereToGetIt)
{
    std::string const no_landlock = trouble_without({SCMP_SYS(landlock_create_ruleset)});
    EXPECT_NE(no_landlock.find("the kernel has no Landlock; a kernel from 5.13 on"), std::string::npos) << no_landlock;
    std::string const no_namespaces = trouble_without({SCMP_SYS(clone)}, {low_bits_are(0, CLONE_NEWPID, CLONE_NEWPID)});
    EXPECT_NE(no_namespaces.find("namespace"), std::string::npos) << no_namespaces;
    EXPECT_NE(no_namespaces.find(geteuid() == 0 ? "virtual machine" : "unprivileged_userns_clone"), std::string::npos)
        << no_namespaces;
}
}  // namespace testat
