// testat batch as tutors use it.
#include "end_to_end/processes.h"
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>

namespace testat {
namespace {
namespace fs = std::filesystem;

/// A folder of uploads, and one for the results.
class Batch : public testing::Test {
protected:
    void SetUp() override
    {
        fs::create_directory(input);
        fs::copy_file(template_file(), input / "anna.cpp");
        write_file(input / "bert.cpp", "int x");
        fs::copy_file(template_file(), input / "carl.cpp");
    }

    std::vector<std::string> arguments(std::vector<std::string> const& more = {}) const
    {
        std::vector<std::string> all{"batch", input.string(), "--out", out.string(), "--deadline", "2099-01-01"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Outcome run_batch(std::vector<std::string> const& more = {}) const { return run_testat(arguments(more)); }
    std::string grades() const { return read_file(out / "grades.csv"); }
    Json report_of(std::string const& student) const
    {
        return Json::parse(read_file(out / "reports" / student / "report.json"));
    }

    TemporaryDirectory const place;
    fs::path const input = place.path() / "in";
    fs::path const out = place.path() / "out";
};

std::size_t count(std::string const& text, std::string const& part)
{
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

bool contains(std::string const& text, std::string const& part)
{
    return count(text, part) > 0;
}

TEST_F(Batch, WritesGradesReportsAndASummary)
{
    Outcome const outcome = run_batch();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "3 uploads, 3 graded, 0 with 60 %")) << outcome.out;
    EXPECT_EQ(count(grades(), "\r\n"), 4u);
    EXPECT_EQ(report_of("carl").at("points").at("earned"), 0.0);
    for (char const* file : {"summary.txt", "overview.html", "junit.xml", "reports/anna/report.txt",
                             "reports/anna/report.html", "reports/anna/results.json"})
        EXPECT_TRUE(fs::exists(out / file)) << file;
}

TEST_F(Batch, TakesRelativePaths)
{
    for (char const* name : {"anna.cpp", "carl.cpp"})
        fs::remove(input / name);
    Outcome const outcome = run_testat({"batch", fs::relative(input).string(), "--out", fs::relative(out).string()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(count(grades(), "\r\n"), 2u);
}

TEST_F(Batch, GradesTheSameFileOnce)
{
    EXPECT_EQ(count(run_batch().err, "Grading "), 2u);
}

TEST_F(Batch, NamesEachStudentsOwnFile)
{
    fs::copy_file(input / "bert.cpp", input / "dora.cpp");
    run_batch();
    for (char const* student : {"bert", "dora"})
        EXPECT_EQ(report_of(student).at("build").at("diagnostics").at(0).at("file"), std::string(student) + ".cpp");
}

TEST_F(Batch, DoesOnlyWhatHasChanged)
{
    run_batch();
    std::string const before = grades();
    Outcome const again = run_batch();
    EXPECT_FALSE(contains(again.err, "Grading")) << again.err;
    EXPECT_EQ(grades(), before);
    write_file(input / "bert.cpp", "int y");
    EXPECT_EQ(count(run_batch().err, "Grading "), 1u);
}

TEST_F(Batch, WritesOnlyWhatHasChanged)
{
    auto const written = [&](char const* student) {
        return fs::last_write_time(out / "reports" / student / "report.html");
    };
    run_batch();
    auto const anna = written("anna");
    auto const bert = written("bert");
    fs::remove(out / "reports" / "carl" / "report.html");
    write_file(out / "overrides.json", R"([{"student": "bert", "function": "total", "points": 12, "reason": "oral",
                                           "who": "Tutor", "when": "2026-11-24"}])");
    run_batch();
    EXPECT_EQ(written("anna"), anna);
    EXPECT_NE(written("bert"), bert);
    EXPECT_TRUE(fs::exists(out / "reports" / "carl" / "report.html"));
}

TEST_F(Batch, GoesOnAfterBeingKilled)
{
    run_batch();
    std::string const undisturbed = grades();
    fs::remove_all(out);

    Running const program(arguments({"--jobs", "1"}), {}, place.path() / "stdout", place.path() / "stderr");
    auto const running = wait_for_upload(program.pid());
    ASSERT_FALSE(running.empty());
    std::vector<Descriptor> handles;
    for (auto const& process : running)
        handles.emplace_back(static_cast<int>(syscall(SYS_pidfd_open, process.pid, 0)));
    program.send(SIGKILL);
    EXPECT_EQ(program.wait(), 128 + SIGKILL);
    for (auto const& process : handles) {
        pollfd p{process.get(), POLLIN, 0};
        EXPECT_TRUE(process.get() < 0 || poll(&p, 1, 60'000) == 1) << "something goes on";
    }
    EXPECT_FALSE(fs::is_empty(out / ".testat/work"));
    EXPECT_EQ(run_batch().exit_code, 0);
    EXPECT_EQ(grades(), undisturbed);
    EXPECT_TRUE(fs::is_empty(out / ".testat/work"));
}

TEST_F(Batch, AsksBeforePointsChange)
{
    write_file(input / "bert.cpp", patched_reference("int ImageTexture::wrap_clamp(int, int) { __builtin_trap(); }\n"));
    run_batch();
    std::string const before = grades();
    Outcome const preview = run_batch({"--lenient"});
    EXPECT_EQ(preview.exit_code, 0);
    EXPECT_TRUE(contains(preview.out, "bert: 0.00 -> 19.00")) << preview.out;
    EXPECT_EQ(grades(), before);
    run_batch({"--lenient", "--apply"});
    EXPECT_NE(grades(), before);
    EXPECT_EQ(report_of("bert").at("points").at("earned"), 19.0);
}

TEST_F(Batch, KeepsTheTutorsWord)
{
    run_batch();
    write_file(out / "overrides.json", R"([{"student": "anna", "function": "total", "points": 12, "reason": "oral",
                                           "who": "Tutor", "when": "2026-11-24"}])");
    EXPECT_EQ(run_batch().exit_code, 0);
    EXPECT_EQ(report_of("anna").at("points").at("earned"), 12.0);
    EXPECT_EQ(report_of("carl").at("points").at("earned"), 0.0);
    EXPECT_TRUE(contains(grades(), "total: 0.00 -> 12.00, oral (Tutor, 2026-11-24)"));
    EXPECT_EQ(run_batch().exit_code, 0);
    EXPECT_EQ(report_of("anna").at("points").at("earned"), 12.0);
}

TEST_F(Batch, LeavesATutorsNotesAlone)
{
    run_batch();
    write_file(out / "reports/anna/notes.txt", "mine");
    write_file(out / "reports/carl/notes.txt", "mine, too");
    fs::remove(input / "carl.cpp");
    run_batch();
    EXPECT_EQ(read_file(out / "reports/anna/notes.txt"), "mine");
    EXPECT_EQ(read_file(out / "reports/carl/notes.txt"), "mine, too");
    fs::remove(out / "reports/carl/notes.txt");
    run_batch();
    EXPECT_FALSE(fs::exists(out / "reports/carl"));
}

TEST_F(Batch, TellsMistakesInOverridesBeforeItGrades)
{
    fs::create_directories(out / ".testat");
    write_file(out / "overrides.json", "[{}]");
    Outcome const outcome = run_batch();
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_FALSE(contains(outcome.err, "Grading")) << outcome.err;
}

TEST_F(Batch, TouchesNoFolderThatIsNotItsOwn)
{
    fs::create_directory(out);
    write_file(out / "thesis.txt", "mine");
    Outcome const outcome = run_batch();
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(read_file(out / "thesis.txt"), "mine");
}

TEST_F(Batch, RefusesWhatIsNoInput)
{
    EXPECT_EQ(run_testat({"batch", (place.path() / "none").string(), "--out", out.string()}).exit_code, 2);
    EXPECT_EQ(run_batch({"--deadline", "tomorrow"}).exit_code, 2);
}
}  // namespace
}  // namespace testat
