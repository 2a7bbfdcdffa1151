// Wrong usage and input that cannot be read: exit code 2, a message, and no report.
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace testat {
namespace {
void expect_refused(Graded const& graded, std::string const& message)
{
    EXPECT_EQ(graded.exit_code, 2) << graded.out << graded.err;
    EXPECT_NE(graded.err.find(message), std::string::npos) << graded.err;
    EXPECT_TRUE(graded.report.is_null());
}

TEST(Input, MayNotBeMissing)
{
    TemporaryDirectory const place;
    expect_refused(grade_file(place.path() / "nothing.cpp", place.path() / "out"), "nothing.cpp");
    EXPECT_FALSE(std::filesystem::exists(place.path() / "out"));
}

TEST(Input, MayNotBeADirectory)
{
    TemporaryDirectory const place;
    expect_refused(grade_file(place.path(), place.path() / "out"), "directory");
}

TEST(Input, MayNotBeADanglingLink)
{
    TemporaryDirectory const place;
    std::filesystem::create_symlink("nowhere", place.path() / "exercise_03.cpp");
    expect_refused(grade_file(place.path() / "exercise_03.cpp", place.path() / "out"), "exercise_03.cpp");
}

TEST(Input, MayNotBeAPipe)
{
    TemporaryDirectory const place;
    ASSERT_EQ(mkfifo((place.path() / "pipe.cpp").c_str(), 0600), 0);
    expect_refused(grade_file(place.path() / "pipe.cpp", place.path() / "out"), "pipe.cpp");
}

TEST(Input, MustBeReadable)
{
    if (geteuid() == 0)
        GTEST_SKIP() << "root may read everything";
    TemporaryDirectory const place;
    write_file(place.path() / "exercise_03.cpp", "int x;\n");
    std::filesystem::permissions(place.path() / "exercise_03.cpp", std::filesystem::perms::none);
    expect_refused(grade_file(place.path() / "exercise_03.cpp", place.path() / "out"), "exercise_03.cpp");
}

TEST(Out, MayNotBeBelowAFile)
{
    TemporaryDirectory const place;
    write_file(place.path() / "file", "");
    Outcome const ran = run_testat({"grade", reference_file().string(), "--out", (place.path() / "file/out").string()});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("file/out"), std::string::npos) << ran.err;
}

/// Whose directory it is does not matter here: nobody can make files in /proc.
TEST(Out, MustBeWritable)
{
    Outcome const ran = run_testat({"grade", reference_file().string(), "--out", "/proc/self"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("/proc/self"), std::string::npos) << ran.err;
}

class Usage : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(Usage, IsChecked)
{
    TemporaryDirectory const place;
    std::vector<std::string> arguments = GetParam();
    if (!arguments.empty() && arguments[0] == "grade")
        arguments.insert(arguments.end(), {"--out", (place.path() / "out").string()});
    Outcome const ran = run_testat(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran.out << ran.err;
    EXPECT_FALSE(ran.err.empty());
    EXPECT_FALSE(std::filesystem::exists(place.path() / "out/report.json"));
}

std::string const file = reference_file().string();
INSTANTIATE_TEST_SUITE_P(
    Wrong, Usage,
    testing::Values(std::vector<std::string>{}, std::vector<std::string>{"grad"}, std::vector<std::string>{"grade"},
                    std::vector<std::string>{"grade", file, "--tasks", "z"},
                    std::vector<std::string>{"grade", file, "--tasks", "a,z"},
                    std::vector<std::string>{"grade", file, "--tasks", "ab"},
                    std::vector<std::string>{"grade", file, "--tasks", ""},
                    std::vector<std::string>{"grade", file, "--seed", "many"},
                    std::vector<std::string>{"grade", file, "--seed", "-1"},
                    std::vector<std::string>{"grade", file, "--lang", "fr"},
                    std::vector<std::string>{"grade", file, "--profile", "dean"},
                    std::vector<std::string>{"grade", file, "--compiler", "cc"},
                    std::vector<std::string>{"grade", file, "--format", "docx"},
                    std::vector<std::string>{"grade", file, "--what"}, std::vector<std::string>{"grade", file, file},
                    std::vector<std::string>{"render"}, std::vector<std::string>{"render", "/nothing.json"},
                    std::vector<std::string>{"doctor", "--what"}));

TEST(Help, IsNoError)
{
    Outcome const ran = run_testat({"--help"});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_NE(ran.out.find("grade"), std::string::npos);
    EXPECT_EQ(run_testat({"grade", "--help"}).exit_code, 0);
    EXPECT_EQ(run_testat({"--version"}).exit_code, 0);
}

TEST(Doctor, FindsThisMachineReady)
{
    Outcome const ran = run_testat({"doctor"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("ready"), std::string::npos);
}
}  // namespace
}  // namespace testat
