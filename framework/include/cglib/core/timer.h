#pragma once

#include <chrono>

/// Measures wall-clock time, monotonic.
class Timer {
public:
    /// Starts now.
    Timer() : start_(Clock::now()) {}

    /// Starts again from zero.
    void restart() { start_ = Clock::now(); }

    /// Since the start, in seconds.
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_;
};
