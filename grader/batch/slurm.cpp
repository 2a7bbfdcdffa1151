#include "batch/slurm.h"

#include "json_schema.h"
#include "report/report.h"
#include "text.h"

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace fs = std::filesystem;
using nlohmann::json;

namespace testat {
namespace {
using Clock = std::chrono::steady_clock;

constexpr char run_prefix[] = "testat-";

/// No array job is larger with Slurm's own defaults.
constexpr std::size_t max_array = 1000;

constexpr char task_script[] =
    "#!/bin/sh\n"
    "# testat, the folder of the run, the number of the first part of this array\n"
    "exec \"$1\" grade-part \"$2/parts/$(($3 + SLURM_ARRAY_TASK_ID)).json\"\n";

/// Clusters keep Slurm in places of their own, so that it is looked up as the caller's shell would.
std::string slurm_program(std::string const& name)
{
    char const* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::string program = folder + "/" + name;
        if (fs::path(folder).is_absolute() && access(program.c_str(), X_OK) == 0)
            return program;
    }
    throw std::runtime_error("--executor slurm: there is no '" + name +
                             "' in PATH; call this on a machine of the cluster, or leave --executor out");
}

/// What Slurm's programs and the tasks need of our environment: the cluster, a tutor's SBATCH_PARTITION and the like.
std::vector<std::string> handed_on()
{
    std::vector<std::string> all;
    for (char** variable = environ; *variable != nullptr; ++variable)
        for (char const* start : {"TMPDIR=", "SLURM_CONF=", "SBATCH_"})
            if (std::string(*variable).rfind(start, 0) == 0)
                all.emplace_back(*variable);
    return all;
}

/// From "123" or "123;cluster", which may stand between warnings; empty if it is not there.
std::string job_number(std::string const& output)
{
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        std::string number = line.substr(0, line.find(';'));
        if (!number.empty() && number.find_first_not_of("0123456789") == std::string::npos)
            return number;
    }
    return "";
}

/// What we ask of Slurm about the jobs of one name.
class Cluster {
public:
    explicit Cluster(std::string name)
        : name_(std::move(name)),
          sbatch_(slurm_program("sbatch")),
          squeue_(slurm_program("squeue")),
          scancel_(slurm_program("scancel"))
    {
    }

    /// Submits an array of `tasks` and gives its number. Throws std::runtime_error.
    std::string submit(std::size_t tasks, std::size_t at_once, fs::path const& log,
                       std::vector<std::string> const& script) const
    {
        std::vector<std::string> arguments{sbatch_,
                                           "--parsable",
                                           "--job-name=" + name_,
                                           fmt::format("--array=0-{}%{}", tasks - 1, at_once),
                                           "--ntasks=1",
                                           "--cpus-per-task=1",
                                           "--no-requeue",
                                           "--output=" + log.string()};
        arguments.insert(arguments.end(), script.begin(), script.end());
        Finished const finished = slurm(arguments);
        std::string number = job_number(finished.output);
        if (finished.exit_code != 0 || number.empty())
            throw std::runtime_error("Slurm took no job: " + said(finished));
        return number;
    }

    /// The tasks, "<job>_<index>", that wait or run, with whether they run; nothing if Slurm does not answer.
    std::optional<std::map<std::string, bool>> tasks() const
    {
        Finished const finished = slurm({squeue_, "--noheader", "--array", "--name=" + name_, "--format=%F_%K %T"});
        if (finished.exit_code != 0)
            return std::nullopt;
        std::map<std::string, bool> all;
        std::istringstream lines(finished.output);
        for (std::string task, state; lines >> task >> state;)
            if (state != "COMPLETING")  // what it had to say, it has said
                all[task] = state == "RUNNING";
        return all;
    }

    /// Whether Slurm has heard it. Comes to its end on Ctrl-C.
    bool cancel() const noexcept
    {
        try {
            return slurm({scancel_, "--name=" + name_}, true).exit_code == 0;
        } catch (std::exception const&) {
            return false;
        }
    }

private:
    static Finished slurm(std::vector<std::string> const& arguments, bool despite_interrupts = false)
    {
        Command command;
        command.argv = arguments;
        command.variables = handed_on();
        command.wall_s = 60;
        command.despite_interrupts = despite_interrupts;
        return run(command);
    }

    static std::string said(Finished const& finished)
    {
        std::string const& output = finished.output;
        return finished.timed_out ? "it does not answer"
                                  : one_line(output.substr(0, output.find_last_not_of('\n') + 1), 400);
    }

    std::string name_;
    std::string sbatch_, squeue_, scancel_;
};

/// What one task grades, as far as it has not done so.
struct Part {
    std::size_t number = 0;
    std::vector<Job const*> open;
    int losses = 0;
    std::string task;  ///< Slurm's name of it
    fs::path log;
    Clock::time_point last_sign;
};

double seconds_since(Clock::time_point time)
{
    return std::chrono::duration<double>(Clock::now() - time).count();
}

fs::path part_file(fs::path const& run, std::size_t number)
{
    return run / "parts" / (std::to_string(number) + ".json");
}

fs::path ended_file(fs::path const& report)
{
    return report.string() + ".ended";
}

/// Of the copy: a name of any bytes becomes one that JSON can hold.
std::string copied_name(Job const& job)
{
    return one_line(job.file.filename().string(), 200);
}

json to_json(Part const& part, GradeSettings const& settings)
{
    json uploads = json::array();
    for (auto const* job : part.open)
        uploads.push_back({{"key", job->key}, {"file", copied_name(*job)}});
    return {{"seed", settings.seed},
            {"lenient", settings.lenient},
            {"compiler", settings.compiler},
            {"uploads", std::move(uploads)}};
}

json to_json(Finished const& finished)
{
    return {{"exit_code", finished.exit_code},
            {"signal", finished.signal},
            {"timed_out", finished.timed_out},
            {"output", clean_text(finished.output, 4096)}};
}

Finished finished_from(json const& document)
{
    Finished finished;
    finished.exit_code = document.at("exit_code");
    finished.signal = document.at("signal");
    finished.timed_out = document.at("timed_out");
    finished.output = document.at("output");
    return finished;
}

/// A new folder for a run, whose name no other run has.
fs::path make_run_folder(fs::path const& folder)
{
    fs::create_directories(folder);
    std::string pattern = (fs::canonical(folder) / (std::string(run_prefix) + "XXXXXX")).string();
    if (mkdtemp(pattern.data()) == nullptr)
        throw std::system_error(errno, std::generic_category(), "folder " + pattern);
    for (char const* name : {"uploads", "parts", "done", "logs"})
        fs::create_directory(fs::path(pattern) / name);
    return pattern;
}

/// A batch that was killed could not tidy up.
void cancel_earlier_runs(fs::path const& folder)
{
    std::error_code error;
    for (auto const& entry : fs::directory_iterator(folder, error)) {
        std::string const name = entry.path().filename().string();
        if (name.rfind(run_prefix, 0) == 0 && Cluster(name).cancel())
            fs::remove_all(entry.path(), error);
    }
}

/// All jobs on their way over the cluster.
class Run {
public:
    Run(GradeSettings const& settings, SlurmSettings const& slurm, JobEnded const& ended)
        : settings_(settings),
          slurm_(slurm),
          ended_(ended),
          folder_(make_run_folder(slurm.folder)),
          cluster_(folder_.filename().string())
    {
    }

    ~Run()
    {
        std::error_code ignored;
        if (!may_run_on_ || cluster_.cancel())
            fs::remove_all(folder_, ignored);
        else
            std::cerr << "testat: Slurm could not be told to cancel what may still run; the next call does it, or: "
                         "scancel --name="
                      << folder_.filename().string() << "\n";
    }
    Run(Run const&) = delete;
    Run& operator=(Run const&) = delete;

    void grade(std::vector<Job> const& jobs)
    {
        copy_uploads(jobs);
        write_atomically(folder_ / "task.sh", task_script);
        submit(deal(jobs));
        while (!parts_.empty()) {
            wait_for(slurm_.look_s);
            collect();
            if (something_is_silent())
                submit(take_lost());
        }
        may_run_on_ = has_lost_;
    }

private:
    void copy_uploads(std::vector<Job> const& jobs) const
    {
        for (auto const& job : jobs) {
            fs::create_directory(folder_ / "uploads" / job.key);
            fs::copy_file(job.file, folder_ / "uploads" / job.key / copied_name(job));
        }
    }

    std::vector<Part> deal(std::vector<Job> const& jobs) const
    {
        std::vector<Part> parts(std::min({jobs.size(), tasks_for_each_at_once * slurm_.at_once, max_array}));
        for (std::size_t i = 0; i < jobs.size(); ++i)
            parts[i % parts.size()].open.push_back(&jobs[i]);
        return parts;
    }

    void submit(std::vector<Part> parts)
    {
        for (std::size_t at = 0; at < parts.size(); at += max_array)
            submit_array(parts.data() + at, std::min(max_array, parts.size() - at));
        std::move(parts.begin(), parts.end(), std::back_inserter(parts_));
    }

    void submit_array(Part* parts, std::size_t count)
    {
        std::size_t const first = next_number_;
        for (std::size_t i = 0; i < count; ++i) {
            parts[i].number = next_number_++;
            fs::create_directory(done(parts[i]));
            write_atomically(part_file(folder_, parts[i].number), to_json(parts[i], settings_).dump());
        }
        may_run_on_ = true;
        std::string const log = std::to_string(first) + "+%a.log";
        std::string const job =
            cluster_.submit(count, slurm_.at_once, folder_ / "logs" / log,
                            {folder_ / "task.sh", fs::canonical(settings_.program), folder_, std::to_string(first)});
        for (std::size_t i = 0; i < count; ++i) {
            parts[i].task = job + "_" + std::to_string(i);
            parts[i].log = folder_ / "logs" / fmt::format("{}+{}.log", first, i);
            parts[i].last_sign = Clock::now();
        }
    }

    fs::path done(Part const& part) const { return folder_ / "done" / std::to_string(part.number); }

    void collect()
    {
        for (auto& part : parts_)
            collect(part);
        parts_.erase(std::remove_if(parts_.begin(), parts_.end(), [](Part const& part) { return part.open.empty(); }),
                     parts_.end());
    }

    /// A network's file system shows a new file in the list of its folder first.
    void collect(Part& part)
    {
        std::map<std::string, fs::path> there;
        for (auto const& entry : fs::directory_iterator(done(part)))
            there[entry.path().filename().string()] = entry.path();
        auto const take_if_there = [&](Job const* job) {
            auto const found = there.find(ended_file(job->key).string());
            if (found == there.end())
                return false;
            take(*job, done(part) / job->key);
            part.last_sign = Clock::now();
            return true;
        };
        part.open.erase(std::remove_if(part.open.begin(), part.open.end(), take_if_there), part.open.end());
    }

    void take(Job const& job, fs::path const& report) const
    {
        Finished const finished = finished_from(read_json(ended_file(report)));
        fs::remove_all(job.out);
        if (fs::exists(report))
            fs::rename(report, job.out);
        ended_(job, finished);
    }

    bool is_silent(Part const& part) const { return seconds_since(part.last_sign) > slurm_.silence_s; }

    bool something_is_silent() const
    {
        return seconds_since(last_asked_) > slurm_.silence_s &&
               std::any_of(parts_.begin(), parts_.end(), [&](Part const& part) { return is_silent(part); });
    }

    /// Takes parts whose tasks are gone out of the list; what they have not graded, to be submitted again.
    std::vector<Part> take_lost()
    {
        last_asked_ = Clock::now();
        auto const tasks = cluster_.tasks();
        collect();  // what has ended before Slurm was asked is not lost
        if (!tasks)
            throw_if_all_is_silent();
        std::vector<Part> lost;
        auto const is_lost = [&](Part& part) { return tasks && is_silent(part) && !lives(part, *tasks); };
        auto const first_lost =
            std::stable_partition(parts_.begin(), parts_.end(), [&](Part& part) { return !is_lost(part); });
        std::move(first_lost, parts_.end(), std::back_inserter(lost));
        parts_.erase(first_lost, parts_.end());
        return parts_of_lost(lost);
    }

    /// A task that waits may do so for ever.
    bool lives(Part& part, std::map<std::string, bool> const& tasks) const
    {
        auto const found = tasks.find(part.task);
        if (found == tasks.end())
            return false;
        if (!found->second)
            part.last_sign = Clock::now();
        return seconds_since(part.last_sign) < slurm_.longest_s;
    }

    void throw_if_all_is_silent() const
    {
        auto const is_silent_for_long = [&](Part const& part) {
            return seconds_since(part.last_sign) > slurm_.longest_s;
        };
        if (!parts_.empty() && std::all_of(parts_.begin(), parts_.end(), is_silent_for_long))
            throw std::runtime_error("Slurm does not answer, and no results come; the same call goes on from here");
    }

    /// The upload that was being graded comes into a part of its own: it may be what ends the tasks.
    std::vector<Part> parts_of_lost(std::vector<Part> const& lost)
    {
        std::vector<Part> parts;
        for (auto const& part : lost) {
            has_lost_ = true;
            if (part.losses == max_losses) {
                give_up(part);
                continue;
            }
            auto const second = part.open.begin() + 1;
            for (auto const& open : {std::vector(part.open.begin(), second), std::vector(second, part.open.end())})
                if (!open.empty())
                    parts.push_back({0, open, part.losses + 1, "", "", {}});
        }
        if (!parts.empty())
            std::cerr << fmt::format("\n{} Slurm tasks were lost; what they have not graded is submitted again.\n",
                                     lost.size());
        return parts;
    }

    void give_up(Part const& part) const
    {
        Finished finished;
        finished.output = fmt::format("the Slurm task that was to grade it was lost {} times", max_losses + 1);
        std::ifstream in(part.log);
        std::string const log = one_line(std::string(std::istreambuf_iterator<char>(in), {}), 300);
        if (!log.empty())
            finished.output += "; the last one said: " + log;
        for (auto const* job : part.open)
            ended_(*job, finished);
    }

    GradeSettings const& settings_;
    SlurmSettings const& slurm_;
    JobEnded const& ended_;
    fs::path const folder_;
    Cluster const cluster_;
    std::vector<Part> parts_;
    std::size_t next_number_ = 0;
    Clock::time_point last_asked_ = Clock::now();
    bool may_run_on_ = false;
    bool has_lost_ = false;
};
}  // namespace

void grade_on_slurm(std::vector<Job> const& jobs, GradeSettings const& settings, SlurmSettings const& slurm,
                    JobEnded const& ended)
{
    cancel_earlier_runs(slurm.folder);
    Run(settings, slurm, ended).grade(jobs);
}

void grade_part(fs::path const& part)
{
    json const document = read_json(part);
    fs::path const run = fs::absolute(part).parent_path().parent_path();
    GradeSettings settings;
    settings.seed = document.at("seed");
    settings.lenient = document.at("lenient");
    settings.compiler = document.at("compiler");
    std::vector<Job> jobs;
    for (auto const& upload : document.at("uploads")) {
        std::string const key = upload.at("key");
        jobs.push_back(
            {key, key, run / "uploads" / key / upload.at("file").get<std::string>(), run / "done" / part.stem() / key});
    }
    grade_here(jobs, settings, 1, [](Job const& job, Finished const& finished) {
        write_atomically(ended_file(job.out), to_json(finished).dump());
    });
}
}  // namespace testat
