#pragma once
#include "batch/executor.h"

#include <cstddef>
#include <filesystem>
#include <vector>

/// Grades on the nodes of a cluster: array jobs of Slurm, of which each task grades a part of the uploads, one after
/// the other. Progress is what appears in a folder that all nodes share; Slurm itself is only asked after tasks that
/// have given no sign for a while. A task that is gone is submitted again with what it has not graded.
///
///   <folder>/testat-XXXXXX/   one run; its jobs have this name, so that they are found and cancelled by it
///     task.sh                 what each task runs
///     uploads/<key>/          copies, because nodes do not see what was unpacked here
///     parts/<n>.json          what one task grades
///     done/<n>/<key>/         a report, under way or whole
///     done/<n>/<key>.ended    ... whole, and how `testat grade` ended
///     logs/                   what tasks say
///
/// Two tasks never write into the same folder, and nobody but the batch writes elsewhere: a task that was believed
/// lost, or that outlives a killed batch, does no harm.
namespace testat {
struct SlurmSettings {
    std::filesystem::path folder;  ///< ours alone, and shared by all nodes
    std::size_t at_once = 1;       ///< so many tasks run side by side
    double look_s = 0.5;           ///< from one look for results to the next
    double silence_s = 10;         ///< a task that has given no sign for so long is asked after
    double longest_s = 360;        ///< a running task gives a sign more often: no upload is graded for so long
};

/// Uploads are dealt to at most so many tasks for each that runs at a time: starting one costs about 0.4 s, and few
/// would leave nodes idle in the end.
constexpr std::size_t tasks_for_each_at_once = 4;

/// A task that was lost is submitted again, and so on, this often.
constexpr int max_losses = 3;

/// Grades jobs on the cluster; cancels what an earlier run has left there. Jobs whose tasks are lost too often are
/// given up. Throws std::runtime_error if Slurm is not installed or does not answer, Interrupted on Ctrl-C; no job is
/// left on the cluster then.
void grade_on_slurm(std::vector<Job> const& jobs, GradeSettings const& settings, SlurmSettings const& slurm,
                    JobEnded const& ended);

/// What a task of the cluster does: grades the uploads of `<run>/parts/<n>.json`.
void grade_part(std::filesystem::path const& part);
}  // namespace testat
