#include "batch/executor.h"

#include "batch/slurm.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>

namespace testat {
namespace {
/// What graders take over of our environment: where temporary files go, and how memory is handed out.
std::vector<std::string> variables()
{
    std::vector<std::string> kept;
    for (std::string const name : {"TMPDIR", "GLIBC_TUNABLES"})
        if (char const* const value = std::getenv(name.c_str()))
            kept.push_back(name + "=" + value);
    return kept;
}
}  // namespace

std::vector<std::string> grade_command(Job const& job, GradeSettings const& settings)
{
    // It runs in another folder.
    std::vector<std::string> command{std::filesystem::canonical(settings.program),
                                     "grade",
                                     "--out",
                                     std::filesystem::absolute(job.out),
                                     "--seed",
                                     std::to_string(settings.seed),
                                     "--compiler",
                                     settings.compiler};
    if (settings.lenient)
        command.emplace_back("--lenient");
    command.emplace_back("--");
    command.emplace_back(std::filesystem::absolute(job.file));
    return command;
}

void grade_here(std::vector<Job> const& jobs, GradeSettings const& settings, std::size_t at_once, JobEnded const& ended)
{
    constexpr double longest_s = 300;  // what is the upload's doing ends much earlier
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    auto const work = [&] {
        try {
            for (std::size_t i = next++; i < jobs.size(); i = next++) {
                Command command;
                command.argv = grade_command(jobs[i], settings);
                command.variables = variables();
                command.wall_s = longest_s;
                Finished const finished = run(command);
                std::lock_guard<std::mutex> const lock(mutex);
                ended(jobs[i], finished);
            }
        } catch (...) {
            next = jobs.size();
            std::lock_guard<std::mutex> const lock(mutex);
            failure = std::current_exception();
        }
    };
    std::vector<std::thread> workers;
    for (std::size_t i = 0; i < std::min(at_once, jobs.size()); ++i)
        workers.emplace_back(work);
    for (auto& worker : workers)
        worker.join();
    if (failure)
        std::rethrow_exception(failure);
}

void grade_at(Place const& place, std::vector<Job> const& jobs, GradeSettings const& settings, JobEnded const& ended)
{
    if (place.executor == Executor::local)
        return grade_here(jobs, settings, place.at_once, ended);
    SlurmSettings slurm;
    slurm.folder = place.shared;
    slurm.at_once = place.at_once;
    grade_on_slurm(jobs, settings, slurm, ended);
}

bool was_given_up(Finished const& finished)
{
    return finished.exit_code < 0 && finished.signal == 0;
}
}  // namespace testat
