#include "end_to_end/processes.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace testat {
namespace {
std::vector<Process> processes()
{
    std::vector<Process> all;
    for (auto const& entry : std::filesystem::directory_iterator("/proc")) {
        std::string line;
        std::getline(std::ifstream(entry.path() / "stat"), line);
        std::size_t const name = line.find('('), end = line.rfind(')');
        if (name == std::string::npos || end == std::string::npos)
            continue;
        pid_t const parent = std::stoi(line.substr(end + 4));
        all.push_back({std::stoi(line), parent, line.substr(name + 1, end - name - 1)});
    }
    return all;
}
}  // namespace

std::vector<Process> descendants(pid_t ancestor)
{
    std::vector<Process> const all = processes();
    std::vector<Process> found;
    std::vector<pid_t> parents{ancestor};
    for (std::size_t i = 0; i < parents.size(); ++i)
        for (auto const& process : all)
            if (process.parent == parents[i]) {
                found.push_back(process);
                parents.push_back(process.pid);
            }
    return found;
}

std::vector<Process> wait_for_upload(pid_t program)
{
    constexpr std::chrono::milliseconds pause(20);
    for (auto waited = pause; waited < std::chrono::minutes(1); waited += pause) {
        std::this_thread::sleep_for(pause);
        auto const found = descendants(program);
        auto const is_probe = [](Process const& process) { return process.name == "probe"; };
        if (std::count_if(found.begin(), found.end(), is_probe) >= 2)
            return found;
    }
    return {};
}
}  // namespace testat
