#include "probe/child.h"

#include "probe/answer.h"
#include "probe/memory.h"
#include "probe/slots.h"
#include "probe/variables.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cfenv>
#include <clocale>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <system_error>

namespace testat {
namespace {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool limit_memory = false;  // sanitizers reserve terabytes of address space
#else
constexpr bool limit_memory = true;
#endif
constexpr rlim_t memory_bytes = rlim_t(2) << 30;
constexpr rlim_t kept_output_bytes = 64 << 10;

void set_limit(__rlimit_resource resource, rlim_t soft, rlim_t hard)
{
    rlimit const value{soft, hard};
    setrlimit(resource, &value);
}

void set_limits(double cpu_s)
{
    auto const seconds = static_cast<rlim_t>(std::ceil(cpu_s));
    set_limit(RLIMIT_CPU, seconds, seconds + 1);
    set_limit(RLIMIT_CORE, 0, 0);
    if (limit_memory)
        set_limit(RLIMIT_AS, memory_bytes, memory_bytes);
    // Printing beyond the limit fails instead of killing: noise is no crime.
    signal(SIGXFSZ, SIG_IGN);
    set_limit(RLIMIT_FSIZE, kept_output_bytes, kept_output_bytes);
}

void redirect(int output)
{
    int const null = open("/dev/null", O_RDONLY);
    dup2(null, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    close_range(3, ~0u, 0);
}

void note(Blackboard& board, char const* text)
{
    std::snprintf(board.text, sizeof board.text, "%s", text);
}

std::string reference_for(FunctionSet from_upload, std::string const& directory)
{
    for (Function f : every_function())
        if (from_upload == FunctionSet::only(f))
            return directory + "/without_" + std::string(info(f).name) + ".so";
    return directory + "/all.so";
}

/// As it was before the upload's constructors ran.
void reset_arithmetic()
{
    std::fesetenv(FE_DFL_ENV);
    std::setlocale(LC_ALL, "C");
}

/// The upload as dlopen gives it.
void* load(ChildTask const& task)
{
    FunctionSet const wanted = task.group.from_upload;
    if (wanted != FunctionSet::all()) {
        void* const reference = load_library(reference_for(wanted, task.libraries.references));
        remove_bodies(reference, wanted);
        fill_slots(reference, FunctionSet(FunctionSet::all().bits() & ~wanted.bits()));
    }
    task.restrictions.before_loading(task.group.kind == Kind::rendering);
    void* const upload = load_library(task.libraries.upload);
    task.restrictions.after_loading();
    reset_arithmetic();
    fill_slots(upload, wanted);
    return upload;
}

/// Null if the libraries are not in place, or if a constructor of the upload has kept us from restricting it further.
void* try_to_load(ChildTask const& task)
{
    task.board.phase = Phase::loading;
    try {
        return load(task);
    } catch (std::exception const& e) {
        note(task.board, e.what());
        task.board.phase = Phase::not_loaded;
        return nullptr;
    }
}

double cpu_seconds()
{
    timespec now = {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

void answer_once(ChildTask const& task)
{
    task.board.pass_s = answer(task.group, task.textures, task.assets, task.answers, &task.board.answered);
}

/// Caches fill up the first time; what grows the second time grows for ever.
void answer_again(ChildTask const& task)
{
    double const before = heap_in_use();
    answer_once(task);
    task.board.kept = heap_in_use() - before;
}

void answer_all(ChildTask const& task, void* upload)
{
    task.board.phase = Phase::running;
    try {
        double const start = cpu_seconds();
        Variables const variables(upload);
        prepare_memory(task.group.fill);
        answer_once(task);
        if (task.group.twice)
            answer_again(task);
        task.board.work_s = cpu_seconds() - start;
        task.board.wrote = variables.have_changed() ? 1 : 0;
        task.board.phase = Phase::done;
    } catch (std::exception const& e) {
        note(task.board, e.what());
        task.board.phase = Phase::threw;
    } catch (...) {
        task.board.phase = Phase::threw;
    }
}
}  // namespace

bool can_be_restricted(Restrictions const& restrictions)
{
    pid_t const pid = fork();
    if (pid < 0)
        throw std::system_error(errno, std::generic_category(), "fork");
    if (pid == 0) {
        try {
            restrictions.before_loading(false);
            restrictions.after_loading();
            _exit(0);
        } catch (std::exception const& e) {
            std::fprintf(stderr, "probe: %s\n", e.what());
            _exit(1);
        }
    }
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    return status == 0;
}

void become_child(ChildTask const& task)
{
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    set_limits(task.cpu_s);
    redirect(task.output);
    if (void* const upload = try_to_load(task))
        answer_all(task, upload);
    std::fflush(stdout);
    _exit(0);
}
}  // namespace testat
