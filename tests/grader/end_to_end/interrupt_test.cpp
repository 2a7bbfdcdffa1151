// Ctrl-C while an upload runs: nothing of it stays behind.
#include "end_to_end/testat_program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <csignal>

namespace testat {
namespace {
constexpr int patience_ms = 60'000;

bool readable(int fd)
{
    pollfd p{fd, POLLIN, 0};
    return poll(&p, 1, patience_ms) == 1;
}

/// Sends its process and its parent's through a pipe, then never ends.
std::string endless_upload(std::filesystem::path const& pipe)
{
    return "#include <fcntl.h>\n#include <unistd.h>\n" + patched_reference(
                                                             "int ImageTexture::wrap_clamp(int val, int size)\n"
                                                             "{\n"
                                                             "    pid_t const processes[2] = {getpid(), getppid()};\n"
                                                             "    int const fd = open(\"" +
                                                             pipe.string() +
                                                             "\", O_WRONLY);\n"
                                                             "    if (write(fd, processes, sizeof processes) < 0)\n"
                                                             "        return size;\n"
                                                             "    for (volatile int i = val;; i = i + 1) {\n"
                                                             "    }\n"
                                                             "}\n");
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, LeavesNoProcessAndNoFile)
{
    TemporaryDirectory const place;
    auto const pipe = place.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    Descriptor const reader(open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    std::filesystem::create_directory(place.path() / "tmp");
    write_file(place.path() / "exercise_03.cpp", endless_upload(pipe));

    Running const program({"grade", (place.path() / "exercise_03.cpp").string(), "--no-sandbox", "--tasks", "b",
                           "--out", (place.path() / "report").string()},
                          {"TMPDIR=" + (place.path() / "tmp").string()}, place.path() / "out", place.path() / "err");
    ASSERT_TRUE(readable(reader.get())) << "the upload has not been run";
    pid_t processes[2] = {};
    ASSERT_EQ(read(reader.get(), processes, sizeof processes), ssize_t(sizeof processes));
    Descriptor const child(int(syscall(SYS_pidfd_open, processes[0], 0)));
    Descriptor const probe(int(syscall(SYS_pidfd_open, processes[1], 0)));
    program.send(GetParam());

    EXPECT_EQ(program.wait(), 130);
    EXPECT_TRUE(readable(child.get())) << "the upload still runs";
    EXPECT_TRUE(readable(probe.get())) << "the probe still runs";
    EXPECT_TRUE(std::filesystem::is_empty(place.path() / "tmp"));
    EXPECT_FALSE(std::filesystem::exists(place.path() / "report/report.json"));
    EXPECT_NE(read_file(place.path() / "err").find("interrupted"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM),
                         [](auto const& p) { return p.param == SIGINT ? "SIGINT" : "SIGTERM"; });
}  // namespace
}  // namespace testat
