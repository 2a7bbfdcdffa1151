#include "process/tree.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace testat {
namespace {
/// Four times in clock ticks: user and system time of the process and of the children it has waited for.
double cpu_seconds_of(fs::path const& process)
{
    std::ifstream in(process / "stat");
    std::string text;
    std::getline(in, text, '\0');
    // Behind the name, which is in parentheses and may hold anything, stand the state and ten more fields.
    std::size_t at = text.rfind(')');
    constexpr int fields_before = 12;
    for (int i = 0; i < fields_before && at != std::string::npos; ++i)
        at = text.find(' ', at + 1);
    if (at == std::string::npos)
        return 0;
    long long ticks = 0;
    char const* rest = text.c_str() + at;
    for (int i = 0; i < 4; ++i) {
        char* end = nullptr;
        ticks += std::strtoll(rest, &end, 10);
        rest = end;
    }
    return double(ticks) / double(sysconf(_SC_CLK_TCK));
}

/// From the scheduler's figures, which a kernel may lack; nanoseconds.
double waited_seconds_of(fs::path const& process)
{
    double computed = 0;
    double waited = 0;
    std::ifstream(process / "schedstat") >> computed >> waited;
    return 1e-9 * waited;
}

struct Pages {
    std::size_t resident = 0;
    std::size_t shared = 0;
};

Pages pages_of(fs::path const& process)
{
    Pages pages;
    std::size_t size = 0;
    std::ifstream(process / "statm") >> size >> pages.resident >> pages.shared;
    return pages;
}

void add_children(fs::path const& process, std::vector<pid_t>& to)
{
    std::error_code gone;
    for (fs::directory_iterator thread(process / "task", gone), end; !gone && thread != end; thread.increment(gone)) {
        std::ifstream children(thread->path() / "children");
        for (pid_t child; children >> child;)
            to.push_back(child);
    }
}
}  // namespace

long long out_of_memory_kills()
{
    std::ifstream in("/proc/vmstat");
    std::string name;
    for (long long count = 0; in >> name >> count;)
        if (name == "oom_kill")
            return count;
    return 0;
}

TreeUsage usage_of_tree(pid_t root)
{
    TreeUsage usage;
    std::size_t own = 0;
    std::size_t shared = 0;
    std::vector<pid_t> tree{root};
    for (std::size_t i = 0; i < tree.size(); ++i) {
        fs::path const process = "/proc/" + std::to_string(tree[i]);
        usage.cpu_s += cpu_seconds_of(process);
        usage.waited_s[tree[i]] = waited_seconds_of(process);
        Pages const pages = pages_of(process);
        own += pages.resident - std::min(pages.shared, pages.resident);
        shared = std::max(shared, pages.shared);
        add_children(process, tree);
    }
    usage.memory = (own + shared) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return usage;
}
}  // namespace testat
