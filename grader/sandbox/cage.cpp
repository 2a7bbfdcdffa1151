#include "sandbox/cage.h"

#include "installation.h"
#include "sandbox/system_calls.h"
#include "text.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <set>
#include <system_error>

namespace fs = std::filesystem;

namespace testat {
namespace {
using Arguments = std::vector<std::string>;

/// Where the word that the cage stands goes to, inside; where bwrap says which process is the first of its namespace.
constexpr int ready_descriptor = 9;
constexpr int info_descriptor = 10;
/// The compiler's driver, its parts and the linker's threads; the probe's server, a child and its threads.
constexpr int processes = 32;

void append(Arguments& to, Arguments const& more)
{
    to.insert(to.end(), more.begin(), more.end());
}

/// Root needs no user namespace, and what root alone may read can be mounted; for anybody else there is no other way.
/// Inside of one no further ones can be made; without one, confine's filter and user see to that.
Arguments namespaces(bool as_root)
{
    Arguments all{"--unshare-ipc", "--unshare-pid",        "--unshare-net",
                  "--unshare-uts", "--unshare-cgroup-try", "--die-with-parent",
                  "--new-session", "--cap-drop",           "ALL"};
    append(all, as_root ? Arguments{"--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"}
                        : Arguments{"--unshare-user", "--disable-userns"});
    return all;
}

/// bwrap lets nobody but root into folders that it makes because something below them is mounted.
Arguments folders_above(std::vector<fs::path> const& paths)
{
    std::set<fs::path> folders;
    for (auto const& path : paths)
        for (fs::path folder = path.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
            folders.insert(folder);
    Arguments all;
    for (auto const& folder : folders)
        append(all, {"--dir", folder});
    return all;
}

Arguments mounts(Caged const& caged, fs::path const& confine)
{
    Arguments all;
    if (caged.temporary_files)
        append(all, {"--perms", "1777", "--size", "268435456", "--tmpfs", "/tmp"});
    append(all, {"--symlink", "usr/lib", "/lib", "--symlink", "usr/lib64", "/lib64", "--symlink", "usr/bin", "/bin"});
    std::vector<fs::path> above = caged.sees;
    above.insert(above.end(), {confine, "/dev/null"});
    if (caged.writes)
        above.push_back(*caged.writes);
    append(all, folders_above(above));
    for (auto const& path : caged.sees)
        append(all, {"--ro-bind-try", path, path});
    append(all, {"--ro-bind", confine, confine, "--dev-bind", "/dev/null", "/dev/null"});
    if (caged.writes)
        append(all, {"--bind", *caged.writes, *caged.writes});
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    append(all, {"--proc", "/proc"});  // sanitizers read their process's mappings
#endif
    append(all, {"--remount-ro", "/", "--chdir", caged.command.directory});
    return all;
}

std::string whole(double number)
{
    return std::to_string(static_cast<unsigned long long>(std::ceil(number)));
}

Arguments confined(Command const& command, fs::path const& confine, uid_t uid)
{
    Arguments all{confine,
                  std::to_string(uid),
                  std::to_string(ready_descriptor),
                  whole(command.cpu_s),
                  std::to_string(command.address_space),
                  std::to_string(command.file_size),
                  std::to_string(processes)};
    append(all, command.argv);
    return all;
}

bool is_open_to_all(fs::path const& path)
{
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0)
        return true;  // that is another problem
    mode_t const needed = S_ISDIR(status.st_mode) ? S_IROTH | S_IXOTH : S_IROTH;
    return (status.st_mode & needed) == needed;
}

/// The first part of ours that another user cannot read, though the cage shows it; empty if there is none.
std::string closed_part()
{
    auto const& where = installation();
    for (auto const& part : {where.include, where.headers, where.references, where.assets}) {
        if (!is_open_to_all(part))
            return part;
        for (auto const& entry : fs::recursive_directory_iterator(part))
            if (!is_open_to_all(entry.path()))
                return entry.path();
    }
    for (char const* file : {"confine", "probe", "libtestat_framework.so", "libtestat_trampolines.so"})
        if (!is_open_to_all(where.libraries / file))
            return where.libraries / file;
    return "";
}

class Pipe {
public:
    Pipe()
    {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw std::system_error(errno, std::generic_category(), "pipe for the cage");
        out_ = Descriptor(ends[0]);
        in_ = Descriptor(ends[1]);
    }
    int in() const { return in_.get(); }

    /// What the other side has written; it is gone.
    std::string read_rest()
    {
        in_.reset();
        char words[1024];
        ssize_t const got = read(out_.get(), words, sizeof words);
        return {words, static_cast<std::size_t>(std::max<ssize_t>(got, 0))};
    }

private:
    Descriptor out_;
    Descriptor in_;
};

/// The first process of a cage's namespace becomes our child when bwrap ends, which does not wait for it. Once it is
/// gone, so are all others, and it knows their CPU time.
double reap_namespace(std::string const& info)
{
    auto const parsed = nlohmann::json::parse(info, nullptr, false);
    if (!parsed.is_object() || !parsed.contains("child-pid"))
        return 0;
    rusage usage{};
    while (wait4(parsed.at("child-pid").get<pid_t>(), nullptr, 0, &usage) < 0)
        if (errno != EINTR)
            return 0;
    return cpu_seconds(usage);
}

/// The kernel's limit is for each process, and what a compiler's driver says of its parts is hard to tell.
bool is_out_of_cpu_time(Finished const& finished, double limit_s)
{
    constexpr double nearly = 0.98;
    return limit_s > 0 && finished.exit_code != 0 && (finished.signal == SIGXCPU || finished.cpu_s >= nearly * limit_s);
}

/// bwrap ends with 128 + N where its program ended by signal N.
void unwrap_signal(Finished& finished)
{
    if (finished.exit_code <= 128)
        return;
    finished.signal = finished.exit_code - 128;
    finished.exit_code = -1;
}

/// Nothing of the namespace is left afterwards, however this ends.
Finished run_and_reap(Command const& outer, Pipe& info)
{
    try {
        Finished finished = run(outer);
        finished.cpu_s += reap_namespace(info.read_rest());
        return finished;
    } catch (...) {
        reap_namespace(info.read_rest());
        throw;
    }
}

Finished run_caged(Caged const& caged, uid_t uid)
{
    fs::path const confine = installation().libraries / "confine";
    Pipe ready;
    Pipe info;
    Command outer = caged.command;
    outer.argv = {"bwrap"};
    append(outer.argv, namespaces(geteuid() == 0));
    append(outer.argv, mounts(caged, confine));
    append(outer.argv, {"--info-fd", std::to_string(info_descriptor), "--"});
    append(outer.argv, confined(caged.command, confine, uid));
    outer.directory = "/";
    outer.descriptors.emplace_back(ready.in(), ready_descriptor);
    outer.descriptors.emplace_back(info.in(), info_descriptor);
    outer.cpu_s = 0;
    outer.address_space = outer.file_size = 0;
    Finished finished = run_and_reap(outer, info);
    std::string const word = ready.read_rest();
    if (word.empty() && !finished.timed_out)
        throw std::runtime_error("the cage for the file could not be put up (see testat doctor): " +
                                 one_line(finished.output, 400));
    if (word == "rx")
        throw std::runtime_error("cannot run " + caged.command.argv[0] + ": " + clean_text(finished.output, 400));
    if (finished.signal != 0 && !finished.timed_out)
        throw std::runtime_error(caged.command.argv[0] + " was ended from outside");
    unwrap_signal(finished);
    return finished;
}
}  // namespace

Cage::Cage(Confinement confinement, Allowance allowance) : allowance_(allowance)
{
    if (confinement == Confinement::none)
        return;
    if (!is_in_path("bwrap"))
        throw std::runtime_error("there is no cage for the file: bubblewrap is not installed (see testat doctor)");
    if (landlock_version() == 0)
        throw std::runtime_error("there is no cage for the file: this kernel has no Landlock (see testat doctor)");
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // for reap_namespace
    slot_.emplace();
    if (std::string const closed = slot_->uid() != 0 ? closed_part() : ""; !closed.empty())
        throw std::runtime_error("the cage's user cannot read " + closed + "; let everybody read it (chmod -R o+rX)");
}

Allowance Cage::left() const
{
    std::lock_guard<std::mutex> const lock(mutex_);
    return {allowance_.cpu_s - spent_cpu_s_, allowance_.wall_s - spent_wall_s_, allowance_.memory};
}

Finished Cage::run(Caged const& caged)
{
    Allowance const most = left();
    Finished finished;
    constexpr double worth_starting_s = 0.1;
    finished.timed_out = !(most.cpu_s > worth_starting_s && most.wall_s > worth_starting_s);
    if (finished.timed_out)
        return finished;
    Caged limited = caged;
    limited.command.wall_s = std::min(caged.command.wall_s, most.wall_s);
    limited.command.cpu_s = std::min(caged.command.cpu_s, most.cpu_s);
    limited.command.tree_cpu_s = most.cpu_s;
    limited.command.tree_memory = allowance_.memory;
    finished = slot_ ? run_caged(limited, slot_->uid()) : testat::run(limited.command);
    finished.timed_out = finished.timed_out || is_out_of_cpu_time(finished, limited.command.cpu_s);
    std::lock_guard<std::mutex> const lock(mutex_);
    spent_cpu_s_ += finished.cpu_s;
    spent_wall_s_ += finished.wall_s;
    return finished;
}

void Cage::show(fs::path const& directory) const
{
    bool const to_another = slot_ && slot_->uid() != 0;
    if (to_another && (chown(directory.c_str(), 0, slot_->uid()) != 0 || chmod(directory.c_str(), 0750) != 0))
        throw std::system_error(errno, std::generic_category(), "showing " + directory.string());
}

void Cage::hand_over(fs::path const& directory) const
{
    if (slot_ && slot_->uid() != 0 && chown(directory.c_str(), slot_->uid(), slot_->uid()) != 0)
        throw std::system_error(errno, std::generic_category(), "handing over " + directory.string());
}

CageTrouble find_cage_trouble()
{
    if (!is_in_path("bwrap"))
        return {"bubblewrap is not installed", "apt-get install bubblewrap"};
    if (landlock_version() == 0)
        return {"the kernel has no Landlock", "a kernel from 5.13 on, with lsm=landlock,... on its command line"};
    try {
        Caged trial;
        trial.command.argv = {"/usr/bin/true"};
        trial.command.wall_s = 10;
        trial.command.cpu_s = 5;
        trial.sees = library_directories();
        trial.sees.emplace_back("/usr/bin/true");
        if (Cage cage(Confinement::cage); cage.run(trial).exit_code != 0)
            return {"a program in the cage failed", "report this"};
        return {};
    } catch (std::exception const& e) {
        return {one_line(e.what()),
                geteuid() == 0
                    ? "run this in a virtual machine, or in a container that may make namespaces"
                    : "as root: sysctl kernel.unprivileged_userns_clone=1 user.max_user_namespaces=10000; or "
                      "students, for their own file: --no-sandbox"};
    }
}

std::vector<fs::path> library_directories()
{
    return {"/usr/lib64", "/usr/lib/x86_64-linux-gnu", "/etc/ld.so.cache"};
}

std::vector<fs::path> compiler_directories()
{
    std::vector<fs::path> all = library_directories();
    for (char const* path : {"/usr/bin", "/usr/include", "/usr/lib/gcc", "/usr/lib/clang", "/etc/alternatives"})
        all.emplace_back(path);
    for (auto const& entry : fs::directory_iterator("/usr/lib"))
        if (entry.path().filename().string().rfind("llvm-", 0) == 0)
            all.push_back(entry.path());
    return all;
}
}  // namespace testat
