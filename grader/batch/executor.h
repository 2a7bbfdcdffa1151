#pragma once
#include "process/run.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace testat {
/// A file to grade, and the folder that its report goes to.
struct Job {
    std::string key;   ///< of the store
    std::string name;  ///< whose it is, for people
    std::filesystem::path file;
    std::filesystem::path out;
};

/// The options that each `testat grade` of a batch gets.
struct GradeSettings {
    std::filesystem::path program = "/proc/self/exe";  ///< testat
    std::uint64_t seed = 1;
    bool lenient = false;
    std::string compiler = "g++";
};

/// Called as each job ends, by one thread at a time, whatever became of it.
using JobEnded = std::function<void(Job const&, Finished const&)>;

/// Runs one `testat grade` for each job, `at_once` of them side by side. Throws Interrupted on Ctrl-C; what has not
/// ended then is gone.
void grade_here(std::vector<Job> const& jobs, GradeSettings const& settings, std::size_t at_once,
                JobEnded const& ended);

/// Where a batch is graded.
enum class Executor { local, slurm };

struct Place {
    Executor executor = Executor::local;
    std::size_t at_once = 1;       ///< processes here, or tasks of a cluster
    std::filesystem::path shared;  ///< by the cluster's nodes: a folder for nothing else
};

/// The same at the place that was chosen, which may give jobs up. Throws std::runtime_error if it is not there.
void grade_at(Place const& place, std::vector<Job> const& jobs, GradeSettings const& settings, JobEnded const& ended);

/// Whether a job was never run to its end, though that was tried several times.
bool was_given_up(Finished const& finished);

/// The command line of such a process.
std::vector<std::string> grade_command(Job const& job, GradeSettings const& settings);
}  // namespace testat
