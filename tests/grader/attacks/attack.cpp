#include "attacks/attack.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <mqueue.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

namespace fs = std::filesystem;

namespace testat {
namespace {
using Lines = std::vector<std::string>;
/// What of the host an attack could have changed, and in which state it is.
using HostState = std::map<std::string, std::string>;

/// Must not be told by any report. No attack holds it: reports quote the file.
constexpr char secret[] = "canary_7e57";
constexpr char first_line_of_passwd[] = "root:x:0";
/// What attacks call what they leave behind; of System V, which has numbers for names, the same in four letters.
constexpr char trace[] = "attacked";
constexpr char trace_of_system_v[] = "1635021921";
/// An upload's allowance is 90 s; the judge itself is to waste no time.
constexpr double longest_s = 120;

struct Grading {
    Graded graded;
    double wall_s = 0;
    Lines changes;
};

std::string replace_all(std::string text, std::string const& from, std::string const& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// The text without the attack: of `#ifndef WITHOUT_ATTACK` ... `#else` ... `#endif` what #else says.
std::string harmless(std::string const& patch)
{
    std::istringstream lines(patch);
    std::string result;
    int depth = 0;  // of conditions, from the attack's own on
    bool skipped = false;
    for (std::string line; std::getline(lines, line);) {
        bool const begins = depth == 0 && line == "#ifndef WITHOUT_ATTACK";
        bool const nested = depth > 0 && line.rfind("#if", 0) == 0;
        bool const alternative = depth == 1 && line.rfind("#else", 0) == 0;
        bool const ends = depth > 0 && line.rfind("#endif", 0) == 0;
        depth += begins || nested ? 1 : ends ? -1 : 0;
        skipped = begins || (skipped && !alternative && depth > 0);
        bool const ours = begins || alternative || (ends && depth == 0);
        if (!skipped && !ours)
            result += line + "\n";
    }
    return result;
}

/// The upload with secrets and files to spoil around it.
class Arena {
public:
    explicit Arena(std::string text)
    {
        for (char const* folder : {"upload", "neighbour", "temporary"})
            fs::create_directories(path(folder));
        text = replace_all(std::move(text), "@UPLOAD@", path("upload"));
        text = replace_all(std::move(text), "@NEIGHBOUR@", path("neighbour"));
        text = replace_all(std::move(text), "@REPOSITORY@", reference_file().parent_path().parent_path());
        write_file(path("upload/exercise_03.cpp"), replace_all(std::move(text), "@BUILD@", TESTAT_BUILD));
        write_file(path("upload/secret.h"), std::string(secret) + "\n");
        write_file(path("upload/points.csv"), "somebody;20\n");
        write_file(path("neighbour/exercise_03.cpp"), std::string("// ") + secret + "\n" + reference_text());
    }

    /// The grader's temporary files go to a folder of their own, and it has a secret in its environment.
    Graded grade() const
    {
        setenv("TMPDIR", path("temporary").c_str(), 1);
        setenv("TESTAT_SECRET", secret, 1);
        Graded graded = grade_file(path("upload/exercise_03.cpp"), path("out"));
        unsetenv("TMPDIR");
        return graded;
    }

    HostState host_state() const
    {
        HostState state;
        for (char const* folder : {"upload", "neighbour", "temporary"})
            add_files(path(folder), state);
        add_files(reference_file().parent_path(), state);
        for (char const* folder : {"/", "/tmp", "/var/tmp", "/dev/shm", "/run"})
            add_traces(folder, state);
        for (char const* kind : {"shm", "sem", "msg"})
            add_lines(std::string("/proc/sysvipc/") + kind, trace_of_system_v, state);
        add_lines("/proc/net/unix", trace, state);
        if (mqd_t const queue = mq_open((std::string("/") + trace).c_str(), O_RDONLY); queue != mqd_t(-1)) {
            state["message queue"] = "there";
            mq_close(queue);
        }
        return state;
    }

private:
    std::string path(std::string const& name) const { return place_.path() / name; }

    static void add_files(fs::path const& folder, HostState& state)
    {
        for (auto const& entry : fs::recursive_directory_iterator(folder)) {
            auto const time = entry.last_write_time().time_since_epoch().count();
            state[entry.path()] = std::to_string(time) + (entry.is_regular_file() ? read_file(entry.path()) : "");
        }
    }

    static void add_traces(fs::path const& folder, HostState& state)
    {
        for (auto const& entry : fs::directory_iterator(folder))
            if (entry.path().filename().string().find(trace) != std::string::npos)
                state[entry.path()] = "there";
    }

    static void add_lines(std::string const& file, std::string const& wanted, HostState& state)
    {
        std::ifstream lines(file);
        for (std::string line; std::getline(lines, line);)
            if (line.find(wanted) != std::string::npos)
                state[file + " with " + wanted] = "there";
    }

    TemporaryDirectory place_;
};

Lines differences(HostState const& before, HostState const& after)
{
    Lines all;
    for (auto const& [what, state] : before)
        if (after.count(what) == 0)
            all.push_back(what + " is gone");
        else if (after.at(what) != state)
            all.push_back(what + " has changed");
    for (auto const& [what, state] : after)
        if (before.count(what) == 0)
            all.push_back(what + " is new");
    return all;
}

/// Whoever lives on belongs to this process now. Ends them all, and says so.
Lines collect_orphans()
{
    constexpr std::chrono::milliseconds grace{50};
    std::this_thread::sleep_for(grace);
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    Lines alive;
    std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
    for (pid_t pid; children >> pid;) {
        alive.push_back("process " + std::to_string(pid) + " lives on");
        kill(pid, SIGKILL);
        waitpid(pid, nullptr, 0);
    }
    return alive;
}

Grading grade_in_arena(std::string const& patch)
{
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    Arena const arena(patched_reference(patch));
    auto const before = arena.host_state();
    auto const start = std::chrono::steady_clock::now();
    Grading grading{arena.grade(), 0, {}};
    grading.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    Lines const alive = collect_orphans();
    grading.changes = differences(before, arena.host_state());
    grading.changes.insert(grading.changes.end(), alive.begin(), alive.end());
    return grading;
}

Grading const& grade_twin(std::string const& patch)
{
    static std::map<std::string, Grading> graded;
    auto const found = graded.find(patch);
    return found != graded.end() ? found->second : graded.emplace(patch, grade_in_arena(patch)).first->second;
}

bool is_graded(Grading const& grading)
{
    return grading.graded.exit_code == 0 && grading.graded.report.value("status", "") == "graded";
}

double points_of(Json const& report)
{
    return report.at("policy").at("earned_without");
}

bool any_says(Json const& report, std::string const& verdict)
{
    auto const& functions = report.at("functions");
    return std::any_of(functions.begin(), functions.end(), [&](auto const& f) { return f.at("verdict") == verdict; });
}

std::string how_ended(Json const& report)
{
    if (!report.at("build").at("ok").get<bool>())
        return "build error";
    return any_says(report, "timed_out") ? "timed out" : any_says(report, "crashed") ? "crashed" : "refused";
}

void compare(std::string const& what, Json const& is, Json const& should_be, Lines& complaints)
{
    if (is != should_be)
        complaints.push_back(what + " is " + is.dump() + " instead of " + should_be.dump());
}

void compare_with_line_1(Json const& report, Json const& expected, Lines& complaints)
{
    bool const builds = expected.value("builds", true);
    double const points = points_of(report);
    if (points < expected.at("earns").at(0).get<double>() || points > expected.at("earns").at(1).get<double>())
        complaints.push_back(fmt::format("earns {} instead of {}", points, expected.at("earns").dump()));
    compare("build.ok", report.at("build").at("ok"), builds, complaints);
    compare("policy", report.at("policy").at("applied"),
            expected.value("policy", builds ? Json::array() : Json({"does_not_compile"})), complaints);
    Json const says = expected.value("says", Json::object());
    for (auto const& [name, function] : report.at("functions").items()) {
        std::string const verdict = says.value(name, says.value("*", "correct"));
        if (builds && verdict != "any")
            compare(name, function.at("verdict"), verdict, complaints);
    }
}

/// Against the same file without the attack, in which all functions can be graded.
void look_for_gains(Json const& functions, Json const& twin, Lines& complaints)
{
    for (auto const& [name, function] : functions.items()) {
        double const gain = function.at("earned").get<double>() - twin.at(name).at("earned").get<double>();
        if (gain > 0)
            complaints.push_back(fmt::format("{} gains {}", name, gain));
    }
}

void look_for_leaks(Graded const& graded, Lines& complaints)
{
    std::string const report = graded.report.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (char const* hidden : {secret, first_line_of_passwd})
        if ((report + graded.out + graded.err).find(hidden) != std::string::npos)
            complaints.push_back(std::string("tells ") + hidden);
    for (std::string const& text : {graded.out, graded.err})
        if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return (c < ' ' && c != '\n') || c == 127; }))
            complaints.emplace_back("prints control characters");
}

Json parse_first_line(std::string const& file, std::string const& patch)
{
    constexpr std::string_view mark = "// attack: ";
    if (patch.rfind(mark, 0) != 0)
        throw std::runtime_error(file + ": line 1 does not say how the attack must end");
    return Json::parse(patch.substr(mark.size(), patch.find('\n') - mark.size()));
}

/// Lines 1 and 2 say what the attack is; twins that differ in nothing else are the same.
std::string behind_two_lines(std::string const& patch)
{
    return patch.substr(patch.find('\n', patch.find('\n') + 1) + 1);
}
}  // namespace

std::vector<Attack> all_attacks()
{
    std::vector<Attack> attacks;
    for (auto const& entry : fs::directory_iterator(TESTAT_ATTACKS)) {
        std::string const patch = read_file(entry.path());
        attacks.push_back(
            {entry.path().stem(), behind_two_lines(patch), parse_first_line(entry.path().string(), patch)});
    }
    std::sort(attacks.begin(), attacks.end(), [](auto const& a, auto const& b) { return a.name < b.name; });
    return attacks;
}

Trial try_attack(Attack const& attack)
{
    Grading const& twin = grade_twin(harmless(attack.patch));
    Grading const grading = grade_in_arena(attack.patch);
    Json const& report = grading.graded.report;
    Trial trial;
    trial.containment_s = std::max(0.0, grading.wall_s - twin.wall_s);
    trial.complaints = trial.changes = grading.changes;
    if (grading.wall_s > longest_s)
        trial.complaints.push_back(fmt::format("takes {:.0f} s", grading.wall_s));
    if (!is_graded(grading) || !is_graded(twin)) {
        trial.complaints.push_back("not graded: " + (is_graded(twin) ? grading : twin).graded.err);
        return trial;
    }
    trial.ended = how_ended(report);
    trial.points = points_of(report);
    trial.points_without = points_of(twin.graded.report);
    compare("without the attack, build.ok", twin.graded.report.at("build").at("ok"), true, trial.complaints);
    compare_with_line_1(report, attack.expected, trial.complaints);
    look_for_gains(report.at("functions"), twin.graded.report.at("functions"), trial.complaints);
    if (report.contains("unofficial"))
        look_for_gains(report.at("unofficial").at("functions"), twin.graded.report.at("functions"), trial.complaints);
    look_for_leaks(grading.graded, trial.complaints);
    return trial;
}

Json grade_next_upload()
{
    TemporaryDirectory const place;
    Graded graded = grade_file(example_file(), place.path() / "out");
    graded.report.erase("timing");
    graded.report.erase("run_time");
    return graded.report;
}
}  // namespace testat
