#pragma once

#include <cstdint>

/// What belongs to one rendering thread alone: its random numbers.
class ThreadLocalData {
public:
    /// The same seed gives the same numbers, on every machine.
    explicit ThreadLocalData(std::uint32_t seed = 0) : state_(seed) {}

    /// Starts the sequence of the seed.
    void set_seed(std::uint32_t seed) { state_ = seed; }

    /// The next number, uniform in [0, 1).
    float rand();

private:
    std::uint32_t state_;
};
