// Ctrl-C while an upload runs: nothing of it stays behind.
#include "end_to_end/testat_program.h"

#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

namespace testat {
namespace {
constexpr int patience_ms = 60'000;

bool has_ended(Descriptor const& process)
{
    pollfd p{process.get(), POLLIN, 0};
    return poll(&p, 1, patience_ms) == 1;
}

std::string endless_upload()
{
    return patched_reference(
        "int ImageTexture::wrap_clamp(int val, int size)\n"
        "{\n"
        "    for (volatile int i = val;; i = i + size) {\n"
        "    }\n"
        "}\n");
}

struct Process {
    pid_t pid = 0;
    pid_t parent = 0;
    std::string name;
};

/// Of all processes of this machine; what ends meanwhile is left out.
std::vector<Process> processes()
{
    std::vector<Process> all;
    for (auto const& entry : std::filesystem::directory_iterator("/proc")) {
        std::string line;
        std::getline(std::ifstream(entry.path() / "stat"), line);
        std::size_t const name = line.find('('), end = line.rfind(')');
        if (name == std::string::npos || end == std::string::npos)
            continue;
        pid_t const parent = std::stoi(line.substr(end + 4));
        all.push_back({std::stoi(line), parent, line.substr(name + 1, end - name - 1)});
    }
    return all;
}

std::vector<Process> descendants(pid_t ancestor)
{
    std::vector<Process> const all = processes();
    std::vector<Process> found;
    std::vector<pid_t> parents{ancestor};
    for (std::size_t i = 0; i < parents.size(); ++i)
        for (auto const& process : all)
            if (process.parent == parents[i]) {
                found.push_back(process);
                parents.push_back(process.pid);
            }
    return found;
}

/// Waits until the upload runs: the probe's server, its child, and whatever is around them.
std::vector<Descriptor> running_below(pid_t program)
{
    std::vector<Descriptor> handles;
    for (int ms = 0; ms < patience_ms && handles.empty(); ms += 20) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        auto const found = descendants(program);
        auto const probes =
            std::count_if(found.begin(), found.end(), [](auto const& process) { return process.name == "probe"; });
        for (auto const& process : found)
            if (probes >= 2)
                handles.emplace_back(static_cast<int>(syscall(SYS_pidfd_open, process.pid, 0)));
    }
    return handles;
}

class Interrupt : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(Interrupt, LeavesNoProcessAndNoFile)
{
    auto const [signal, caged] = GetParam();
    TemporaryDirectory const place;
    std::filesystem::create_directory(place.path() / "tmp");
    write_file(place.path() / "exercise_03.cpp", endless_upload());
    std::vector<std::string> arguments{"grade", (place.path() / "exercise_03.cpp").string(), "--tasks", "b",
                                       "--out", (place.path() / "report").string()};
    if (!caged)
        arguments.emplace_back("--no-sandbox");

    Running const program(arguments, {"TMPDIR=" + (place.path() / "tmp").string()}, place.path() / "out",
                          place.path() / "err");
    auto const running = running_below(program.pid());
    ASSERT_FALSE(running.empty()) << "the upload has not been run";
    program.send(signal);

    EXPECT_EQ(program.wait(), 130);
    for (auto const& process : running)
        EXPECT_TRUE(process.get() < 0 || has_ended(process)) << "something still runs";
    EXPECT_TRUE(std::filesystem::is_empty(place.path() / "tmp"));
    EXPECT_FALSE(std::filesystem::exists(place.path() / "report/report.json"));
    EXPECT_NE(read_file(place.path() / "err").find("interrupted"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Combine(testing::Values(SIGINT, SIGTERM), testing::Bool()),
                         [](auto const& p) {
                             return std::string(std::get<0>(p.param) == SIGINT ? "SIGINT" : "SIGTERM") +
                                    (std::get<1>(p.param) ? "InTheCage" : "WithoutCage");
                         });
}  // namespace
}  // namespace testat
