// What is not the upload's fault ends with exit code 3 and without points, and nothing half-written stays behind.
#include "end_to_end/processes.h"
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace testat {
namespace {
/// Runs the program as root in a mount namespace of its own, prepared by a script. Its output ends with the exit code.
class Prepared {
public:
    explicit Prepared(std::string const& preparation)
    {
        std::filesystem::create_directories(place.path() / "tmp");
        std::filesystem::create_directories(out());
        Command command;
        command.argv = {"unshare",
                        "--mount",
                        "--propagation",
                        "private",
                        "sh",
                        "-c",
                        preparation + "\nTMPDIR=$PWD/tmp " TESTAT_PROGRAM " grade " + reference_file().string() +
                            " --out $PWD/out; code=$?; ls -A tmp out; exit $code"};
        command.directory = place.path();
        finished = run(command);
    }
    std::filesystem::path out() const { return place.path() / "out"; }
    Json report() const { return Json::parse(read_file(out() / "report.json")); }

    TemporaryDirectory const place;
    Finished finished;
};

class NotGradable : public testing::Test {
protected:
    void SetUp() override
    {
        if (geteuid() != 0)
            GTEST_SKIP() << "only root can break a machine";
    }

    static void expect_reason(Prepared const& prepared, std::string const& reason)
    {
        EXPECT_EQ(prepared.finished.exit_code, 3) << prepared.finished.output;
        Json const report = prepared.report();
        EXPECT_EQ(report.at("status"), "not_gradable");
        EXPECT_NE(report.at("error").get<std::string>().find(reason), std::string::npos) << report.at("error");
        EXPECT_FALSE(report.contains("points"));
    }
};

TEST_F(NotGradable, WithoutBubblewrap)
{
    expect_reason(Prepared("mount --bind /dev/null /usr/bin/bwrap"), "bubblewrap is not installed");
}

TEST_F(NotGradable, WithoutCompiler)
{
    expect_reason(Prepared("mount --bind /dev/null /usr/bin/g++"), "g++");
}

TEST_F(NotGradable, WithoutLinker)
{
    expect_reason(Prepared("mount --bind /dev/null /usr/bin/mold"), "the compiler does not work");
}

TEST_F(NotGradable, WithoutNamespaces)
{
    expect_reason(Prepared("exec 3>&1; testat() { setpriv --bounding-set -sys_admin --inh-caps -all \"$@\"; }\n"
                           "testat " TESTAT_PROGRAM " doctor && exit 1\n"
                           "TMPDIR=$PWD/tmp testat " TESTAT_PROGRAM " grade " +
                           reference_file().string() + " --out $PWD/out; exit $?"),
                  "could not be put up");
}

TEST_F(NotGradable, RefusesABatchAtOnce)
{
    Prepared const prepared("mount --bind /dev/null /usr/bin/bwrap; " TESTAT_PROGRAM
                            " batch tmp --out batch; echo $?; ls");
    EXPECT_EQ(prepared.finished.output.find("testat: there is no cage for uploads: bubblewrap is not installed"), 0u)
        << prepared.finished.output;
    EXPECT_EQ(prepared.finished.output.find("batch\n"), std::string::npos) << prepared.finished.output;
    EXPECT_NE(prepared.finished.output.find("\n3\n"), std::string::npos) << prepared.finished.output;
}

TEST_F(NotGradable, RefusesToStressAnUpload)
{
    Prepared const prepared("mount --bind /dev/null /usr/bin/bwrap; " TESTAT_PROGRAM " stress " +
                            reference_file().string() + " --out stress; echo $?");
    EXPECT_NE(prepared.finished.output.find("bubblewrap is not installed"), std::string::npos)
        << prepared.finished.output;
    EXPECT_NE(prepared.finished.output.find("\n3\n"), std::string::npos) << prepared.finished.output;
}

TEST_F(NotGradable, IsExplainedByTheDoctor)
{
    Prepared const prepared("mount --bind /dev/null /usr/bin/bwrap; " TESTAT_PROGRAM " doctor; echo $?");
    EXPECT_NE(
        prepared.finished.output.find("cage for uploads: bubblewrap is not installed; to mend it: apt-get install "
                                      "bubblewrap"),
        std::string::npos)
        << prepared.finished.output;
    EXPECT_NE(prepared.finished.output.find("not ready\n3\n"), std::string::npos) << prepared.finished.output;
}

TEST_F(NotGradable, WithoutRoomToCompile)
{
    expect_reason(Prepared("mount -t tmpfs -o size=1m none tmp; dd if=/dev/zero of=tmp/fill bs=4k 2>/dev/null"),
                  "cannot write");
}

/// There is room for the reason once the pictures that did not fit are gone.
TEST_F(NotGradable, WithoutRoomForThePictures)
{
    Prepared const prepared("mount -t tmpfs -o size=64k none out");
    EXPECT_EQ(prepared.finished.exit_code, 3) << prepared.finished.output;
    std::string const output = prepared.finished.output;
    EXPECT_EQ(output.substr(output.rfind("out:")), "out:\nreport.json\n\ntmp:\n");
}

/// An operator, or a kernel without memory, kills something of ours.
TEST(Killed, IsNotTheUploadsFault)
{
    for (char const* victim : {"bwrap", "probe"}) {
        TemporaryDirectory const place;
        write_file(place.path() / "exercise_03.cpp", endless_text());
        Running const program({"grade", (place.path() / "exercise_03.cpp").string(), "--tasks", "b", "--out",
                               (place.path() / "report").string()},
                              {}, place.path() / "out", place.path() / "err");
        auto const running = wait_for_upload(program.pid());
        auto const found =
            std::find_if(running.begin(), running.end(), [&](auto const& process) { return process.name == victim; });
        ASSERT_NE(found, running.end()) << victim;
        kill(found->pid, SIGKILL);
        EXPECT_EQ(program.wait(), 3) << victim;
        Json const report = Json::parse(read_file(place.path() / "report/report.json"));
        EXPECT_EQ(report.at("status"), "not_gradable") << victim;
    }
}
}  // namespace
}  // namespace testat
