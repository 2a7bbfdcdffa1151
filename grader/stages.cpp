#include "stages.h"

#include "process/run.h"

#include <fmt/core.h>

#include <sys/resource.h>

#include <algorithm>

namespace testat {
double Stages::cpu_ms()
{
    rusage ours{};
    rusage children{};
    getrusage(RUSAGE_SELF, &ours);
    getrusage(RUSAGE_CHILDREN, &children);
    return 1e3 * (cpu_seconds(ours) + cpu_seconds(children));
}

void Stages::end(std::string_view stage)
{
    auto found = std::find_if(stages_.begin(), stages_.end(), [&](auto const& s) { return s.name == stage; });
    if (found == stages_.end())
        found = stages_.insert(found, Stage{std::string(stage)});
    Clock::time_point const wall = Clock::now();
    double const cpu = cpu_ms();
    found->wall_ms += std::chrono::duration<double, std::milli>(wall - wall_).count();
    found->cpu_ms += cpu - cpu_ms_;
    wall_ = wall;
    cpu_ms_ = cpu;
}

double Stages::wall_ms(std::string_view beginning) const
{
    double sum = 0;
    for (auto const& stage : stages_)
        if (std::string_view(stage.name).substr(0, beginning.size()) == beginning)
            sum += stage.wall_ms;
    return sum;
}

std::string Stages::table() const
{
    Stage total{"total"};
    std::string text = fmt::format("{:<28}{:>10}{:>10}\n", "stage", "wall ms", "CPU ms");
    auto const add = [&](Stage const& stage) {
        text += fmt::format("{:<28}{:>10.1f}{:>10.1f}\n", stage.name, stage.wall_ms, stage.cpu_ms);
    };
    for (auto const& stage : stages_) {
        add(stage);
        total.wall_ms += stage.wall_ms;
        total.cpu_ms += stage.cpu_ms;
    }
    add(total);
    return text;
}
}  // namespace testat
