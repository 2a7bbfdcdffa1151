#pragma once
#include "checks/random.h"

#include <cmath>
#include <initializer_list>
#include <limits>

/// Numbers that are unkind to float.
namespace testat {
constexpr float float_max = std::numeric_limits<float>::max();
constexpr float float_infinity = std::numeric_limits<float>::infinity();
constexpr float float_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float denormal = std::numeric_limits<float>::denorm_min();

/// Every order of magnitude between lo and hi is as likely; both above 0.
inline double log_uniform(Random& random, double lo, double hi)
{
    return std::exp(random.uniform(std::log(lo), std::log(hi)));
}

inline double with_any_sign(Random& random, double x)
{
    return random.coin() ? x : -x;
}

template <typename T>
T pick(Random& random, std::initializer_list<T> choices)
{
    return choices.begin()[random.integer(0, int(choices.size()) - 1)];
}

/// The same number, or one float above or below.
inline float next_to(Random& random, float x)
{
    return std::nextafter(x, pick(random, {x, float_infinity, -float_infinity}));
}

/// One time in n.
inline bool seldom(Random& random, int n)
{
    return random.integer(1, n) == 1;
}
}  // namespace testat
