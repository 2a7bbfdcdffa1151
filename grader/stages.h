#pragma once
#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace testat {
/// Where the time of a grading goes: report.json's `timing`, and what `testat grade --timing` prints.
class Stages {
public:
    /// What has been done since the last end, or since the object was made, was of this stage. Stages may be several
    /// times; they are told in the order in which they are first.
    void end(std::string_view stage);

    /// Wall time, in milliseconds, of all stages whose names begin so.
    double wall_ms(std::string_view beginning = "") const;

    /// A line for each stage: wall time and CPU time, with that of processes that have ended, in milliseconds.
    std::string table() const;

private:
    using Clock = std::chrono::steady_clock;
    struct Stage {
        std::string name;
        double wall_ms = 0;
        double cpu_ms = 0;
    };
    static double cpu_ms();

    std::vector<Stage> stages_;
    Clock::time_point wall_ = Clock::now();
    double cpu_ms_ = cpu_ms();
};
}  // namespace testat
