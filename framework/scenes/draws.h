#pragma once

#include <random>

/// The random numbers of a scene, the same on every machine with this standard library.
class Draws {
public:
    /// Uniform in [0, 1).
    float next() { return uniform_(generator_); }

private:
    std::minstd_rand generator_{1337};
    std::uniform_real_distribution<float> uniform_{0.f, 1.f};
};
