#pragma once
#include <chrono>
#include <cstddef>
#include <string>

namespace testat {
/// How far long work has come, on stderr: a bar with the time left on a terminal, a line for each step in a log.
class Progress {
public:
    Progress(std::string title, std::size_t steps);
    ~Progress();
    Progress(Progress const&) = delete;
    Progress& operator=(Progress const&) = delete;

    /// One more step is done; `name` says which.
    void step(std::string const& name);

private:
    std::string title_;
    std::size_t steps_;
    std::size_t done_ = 0;
    bool on_terminal_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "Envelopes  [######----]  12/20  18 s left  plane_after_c". Without the time left before the first step.
std::string progress_line(std::string const& title, std::size_t done, std::size_t steps, double seconds,
                          std::string const& name);
}  // namespace testat
