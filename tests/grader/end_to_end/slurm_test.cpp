// testat batch --executor slurm on a cluster of two nodes on this machine.
#include "end_to_end/processes.h"
#include "end_to_end/testat_program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>

namespace testat {
namespace {
namespace fs = std::filesystem;

bool is_installed(std::string const& daemon)
{
    for (char const* folder : {"/usr/sbin/", "/usr/bin/", "/usr/local/sbin/", "/usr/local/bin/"})
        if (access((folder + daemon).c_str(), X_OK) == 0)
            return true;
    return false;
}

/// Whether it comes true within a minute.
template <typename Condition>
bool comes_true(Condition const& condition)
{
    constexpr std::chrono::milliseconds pause(20);
    for (auto waited = pause; waited < std::chrono::minutes(1); waited += pause) {
        if (condition())
            return true;
        std::this_thread::sleep_for(pause);
    }
    return false;
}

/// A cluster, and a folder of uploads.
class SlurmBatch : public testing::Test {
protected:
    void SetUp() override
    {
        for (char const* daemon : {"munged", "slurmctld", "slurmd"})
            if (!is_installed(daemon))
                GTEST_SKIP() << daemon << " is not installed; ci/setup.sh installs it";
        Finished const up = slurm_up({state.string()});
        ASSERT_EQ(up.exit_code, 0) << up.output;
        fs::create_directory(input);
        write_file(input / "anna.cpp", reference_text());
        for (int i = 0; i < 8; ++i)  // they take the least time
            write_file(input / fmt::format("student_{}.cpp", i), fmt::format("int x{}", i));
    }
    void TearDown() override { EXPECT_EQ(slurm_up({"--down", state.string()}).exit_code, 0); }

    static Finished slurm_up(std::vector<std::string> const& arguments)
    {
        Command command;
        command.argv = {TESTAT_SLURM_UP};
        command.argv.insert(command.argv.end(), arguments.begin(), arguments.end());
        command.wall_s = 60;
        return run(command);
    }

    std::vector<std::string> arguments(fs::path const& out, std::string const& executor) const
    {
        return {"batch", input.string(), "--out",  out.string(), "--jobs",
                "2",     "--executor",   executor, "--deadline", "2099-01-01"};
    }
    std::vector<std::string> variables() const { return {"SLURM_CONF=" + (state / "slurm.conf").string()}; }

    /// The tasks on a node, or on any; a task's environment says where it runs.
    std::vector<pid_t> tasks(std::string const& node) const
    {
        std::vector<pid_t> found;
        for (auto const& process : descendants(1)) {
            std::ifstream in("/proc/" + std::to_string(process.pid) + "/environ", std::ios::binary);
            std::string const environment = std::string(1, '\0') + std::string(std::istreambuf_iterator<char>(in), {});
            if (environment.find('\0' + variables()[0]) != std::string::npos &&
                environment.find('\0' + ("SLURMD_NODENAME=" + node)) != std::string::npos)
                found.push_back(process.pid);
        }
        return found;
    }

    /// As if its power had failed.
    void end_node(std::string const& node) const
    {
        kill(std::stoi(read_file(state / ("slurmd." + node + ".pid"))), SIGKILL);
        for (pid_t const task : tasks(node))
            kill(task, SIGKILL);
    }

    TemporaryDirectory const place;
    fs::path const state = place.path() / "slurm";
    fs::path const input = place.path() / "in";
};

/// What does not depend on when and how fast it was made.
std::string without_times(fs::path const& report)
{
    Json document = Json::parse(read_file(report));
    document.erase("timing");
    document.erase("run_time");
    return document.dump(2);
}

TEST_F(SlurmBatch, GradesAsHereThoughANodeDies)
{
    fs::path const here = place.path() / "here", there = place.path() / "there";
    Running const batch(arguments(there, "slurm"), variables(), place.path() / "stdout", place.path() / "stderr");
    ASSERT_TRUE(comes_true([&] { return !tasks("n1").empty() && !tasks("n2").empty(); }));
    end_node("n2");
    EXPECT_EQ(batch.wait(), 0) << read_file(place.path() / "stderr");
    EXPECT_NE(read_file(place.path() / "stderr").find("lost"), std::string::npos) << "no task was lost";

    Outcome const local = run_testat(arguments(here, "local"));
    EXPECT_EQ(local.exit_code, 0) << local.err;
    EXPECT_EQ(read_file(there / "grades.csv"), read_file(here / "grades.csv"));
    for (auto const& folder : fs::directory_iterator(here / "reports"))
        EXPECT_EQ(without_times(there / "reports" / folder.path().filename() / "report.json"),
                  without_times(folder.path() / "report.json"));
}

TEST_F(SlurmBatch, LeavesNothingOnTheClusterWhenInterrupted)
{
    fs::path const out = place.path() / "out";
    write_file(input / "anna.cpp", endless_text());
    Running const batch(arguments(out, "slurm"), variables(), place.path() / "stdout", place.path() / "stderr");
    ASSERT_TRUE(comes_true([&] { return !tasks("n1").empty() && !tasks("n2").empty(); }));
    batch.send(SIGTERM);
    EXPECT_EQ(batch.wait(), 130);
    EXPECT_TRUE(comes_true([&] { return tasks("n").empty(); })) << "something still runs";
}

}  // namespace
}  // namespace testat
