// The batch's side of Slurm, with programs in the place of Slurm's and of testat that do what a test wants.
#include "batch/slurm.h"

#include "report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

namespace testat {
namespace {
namespace fs = std::filesystem;

/// Notes how it was called, then runs all tasks at once; loses them while there is a file `lose`.
constexpr char sbatch[] = R"(
last=$(echo "$*" | sed 's/.*--array=0-\([0-9]*\)%.*/\1/')
while [ "${1#--}" != "$1" ]; do shift; done
if [ -e $here/lose ]; then rm $here/lose
else for i in $(seq 0 $last); do SLURM_ARRAY_TASK_ID=$i sh "$@" >&2; done
fi
echo "7;cluster"
)";

/// Grades whatever it is given; an upload `poison` ends it.
constexpr char testat_program[] = R"(
run=$(dirname $(dirname $2)) number=$(basename $2 .json)
for key in $(grep -o '"key":"[^"]*"' $2 | cut -d'"' -f4); do
    [ $key != poison ] || exit 1
    report=$run/done/$number/$key
    mkdir $report
    cat $run/uploads/$key/* >$report/report.json
    echo '{"exit_code": 0, "signal": 0, "timed_out": false, "output": "fine"}' >$report.part
    mv $report.part $report.ended
done
)";

class Slurm : public testing::Test {
protected:
    Slurm()
    {
        fs::create_directory(place.path() / "bin");
        program("sbatch", sbatch);
        program("squeue", "");
        program("scancel", "");
        program("testat", testat_program);
        setenv("PATH", (place.path() / "bin").c_str(), 1);
        settings.program = place.path() / "bin/testat";
        slurm.folder = place.path() / "slurm";
        slurm.look_s = 0.01;
        slurm.silence_s = 0.05;
        slurm.longest_s = 60;
    }
    ~Slurm() override { setenv("PATH", path.c_str(), 1); }

    /// A shell script that notes how it was called, with its folder in $here.
    void program(std::string const& name, std::string const& script) const
    {
        fs::path const file = place.path() / "bin" / name;
        write_file(file, "#!/bin/sh\nhere=${0%/*}\necho \"$*\" >>$0.calls\n" + script);
        fs::permissions(file, fs::perms::owner_all);
    }

    std::vector<std::string> calls(std::string const& name) const
    {
        std::ifstream in(place.path() / "bin" / (name + ".calls"));
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);)
            lines.push_back(line);
        return lines;
    }

    void grade(std::vector<std::string> const& keys)
    {
        std::vector<Job> jobs;
        for (auto const& key : keys) {
            fs::path const file = place.path() / (key + ".cpp");
            write_file(file, "of " + key);
            jobs.push_back({key, key, file, place.path() / "out" / key});
        }
        fs::create_directory(place.path() / "out");
        grade_on_slurm(jobs, settings, slurm, [&](Job const& job, Finished const& finished) {
            EXPECT_EQ(ended.count(job.key), 0u) << job.key << " has ended twice";
            ended[job.key] = finished;
        });
    }

    /// Those graded, in order.
    std::string graded() const
    {
        std::string all;
        for (auto const& [key, finished] : ended)
            if (finished.exit_code == 0 && fs::exists(place.path() / "out" / key / "report.json"))
                all += key + " ";
        return all;
    }

    std::string const path = std::getenv("PATH");
    TemporaryDirectory const place;
    GradeSettings settings;
    SlurmSettings slurm;
    std::map<std::string, Finished> ended;
};

using SlurmDeathTest = Slurm;

TEST_F(Slurm, GradesAllInOneArray)
{
    slurm.at_once = 2;
    grade({"a", "b", "c", "d", "e", "f", "g", "h", "i", "j"});
    EXPECT_EQ(graded(), "a b c d e f g h i j ");
    ASSERT_EQ(calls("sbatch").size(), 1u);
    EXPECT_NE(calls("sbatch")[0].find(" --array=0-7%2 "), std::string::npos) << calls("sbatch")[0];
    EXPECT_EQ(ended.at("a").output, "fine");
    EXPECT_TRUE(calls("scancel").empty());
    EXPECT_TRUE(fs::is_empty(slurm.folder));
}

TEST_F(Slurm, GradesCopies)
{
    grade({"a"});
    std::ifstream in(place.path() / "out/a/report.json");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "of a");
}

TEST_F(Slurm, SubmitsLostTasksAgain)
{
    write_file(place.path() / "bin/lose", "");
    grade({"a", "b", "c"});
    EXPECT_EQ(graded(), "a b c ");
    EXPECT_EQ(calls("sbatch").size(), 2u);
    EXPECT_EQ(calls("scancel").size(), 1u);
}

TEST_F(Slurm, GivesUpWhatIsLostTooOftenAndNothingElse)
{
    grade({"poison", "b", "c", "d", "e", "f"});
    EXPECT_EQ(graded(), "b c d e f ");
    EXPECT_EQ(calls("sbatch").size(), 1u + max_losses);
    EXPECT_TRUE(was_given_up(ended.at("poison")));
    EXPECT_NE(ended.at("poison").output.find("lost 4 times"), std::string::npos) << ended.at("poison").output;
}

TEST_F(Slurm, WaitsForTasksInTheQueue)
{
    program("sbatch", "echo \"$*\" | sed 's/.* \\(.*task.sh\\)/\\1/' >$here/task\necho 7");
    program("squeue",
            "[ $(wc -l <$0.calls) -lt 3 ] || SLURM_ARRAY_TASK_ID=0 sh $(cat $here/task)\n"
            "echo 7_0 PENDING\n");
    slurm.longest_s = 0.1;
    grade({"a"});
    EXPECT_EQ(graded(), "a ");
    EXPECT_EQ(calls("sbatch").size(), 1u);
}

TEST_F(Slurm, BelievesNoTaskThatRunsForEver)
{
    write_file(place.path() / "bin/lose", "");
    program("squeue", "echo 7_0 RUNNING");
    slurm.longest_s = 0.3;
    grade({"a"});
    EXPECT_EQ(graded(), "a ");
    EXPECT_EQ(calls("sbatch").size(), 2u);
}

TEST_F(Slurm, SaysThatItDoesNotAnswer)
{
    write_file(place.path() / "bin/lose", "");
    program("squeue", "exit 1");
    slurm.longest_s = 0.3;
    EXPECT_THROW(grade({"a"}), std::runtime_error);
    EXPECT_EQ(calls("scancel").size(), 1u);
}

TEST_F(Slurm, SaysWhyNoJobIsTaken)
{
    program("sbatch", "echo invalid partition; exit 1");
    try {
        grade({"a"});
        FAIL() << "that was no job";
    } catch (std::runtime_error const& e) {
        EXPECT_STREQ(e.what(), "Slurm took no job: invalid partition");
    }
}

TEST_F(Slurm, SaysThatItIsNotInstalled)
{
    fs::remove(place.path() / "bin/sbatch");
    try {
        grade({"a"});
        FAIL() << "there is no sbatch";
    } catch (std::runtime_error const& e) {
        EXPECT_NE(std::string(e.what()).find("no 'sbatch' in PATH"), std::string::npos) << e.what();
    }
}

TEST_F(Slurm, CancelsWhatAKilledRunHasLeft)
{
    fs::create_directories(slurm.folder / "testat-killed/done");
    grade({"a"});
    EXPECT_EQ(calls("scancel"), std::vector<std::string>{"--name=testat-killed"});
    EXPECT_TRUE(fs::is_empty(slurm.folder));
}

TEST_F(Slurm, RemembersWhatCouldNotBeCancelled)
{
    fs::create_directories(slurm.folder / "testat-killed");
    program("scancel", "exit 1");
    grade({"a"});
    EXPECT_TRUE(fs::exists(slurm.folder / "testat-killed"));
}

TEST_F(SlurmDeathTest, CancelsOnCtrlC)
{
    program("sbatch", "kill -INT $PPID; echo 7");
    auto const interrupted = [&] {
        catch_interrupts();
        try {
            grade({"a"});
        } catch (Interrupted const&) {
            std::exit(130);
        }
    };
    EXPECT_EXIT(interrupted(), testing::ExitedWithCode(130), "");
    ASSERT_EQ(calls("scancel").size(), 1u);
    EXPECT_EQ(calls("scancel")[0].rfind("--name=testat-", 0), 0u);
    EXPECT_TRUE(fs::is_empty(slurm.folder));
}
}  // namespace
}  // namespace testat
