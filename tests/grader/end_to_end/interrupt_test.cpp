// Ctrl-C while an upload runs: nothing of it stays behind.
#include "end_to_end/processes.h"
#include "end_to_end/testat_program.h"

#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <csignal>

namespace testat {
namespace {
constexpr int patience_ms = 60'000;

bool has_ended(Descriptor const& process)
{
    pollfd p{process.get(), POLLIN, 0};
    return poll(&p, 1, patience_ms) == 1;
}

class Interrupt : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(Interrupt, LeavesNoProcessAndNoFile)
{
    auto const [signal, caged] = GetParam();
    TemporaryDirectory const place;
    std::filesystem::create_directory(place.path() / "tmp");
    write_file(place.path() / "exercise_03.cpp", endless_text());
    std::vector<std::string> arguments{"grade", (place.path() / "exercise_03.cpp").string(), "--tasks", "b",
                                       "--out", (place.path() / "report").string()};
    if (!caged)
        arguments.emplace_back("--no-sandbox");

    Running const program(arguments, {"TMPDIR=" + (place.path() / "tmp").string()}, place.path() / "out",
                          place.path() / "err");
    std::vector<Descriptor> running;
    for (auto const& process : wait_for_upload(program.pid()))
        running.emplace_back(static_cast<int>(syscall(SYS_pidfd_open, process.pid, 0)));
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
