#pragma once
#include <glm/glm.hpp>

/// Double-precision vectors of the oracles, and how they come from and go to questions.
namespace testat {
/// Half a unit in the last place of 1.f: the largest relative error of one float rounding.
constexpr double eps = 0x1p-24;

inline glm::dvec2 dvec2(float const* v)
{
    return {v[0], v[1]};
}
inline glm::dvec3 dvec3(float const* v)
{
    return {v[0], v[1], v[2]};
}
inline glm::dvec4 dvec4(float const* v)
{
    return {v[0], v[1], v[2], v[3]};
}
/// Column-major, as questions store it.
inline glm::dmat4 dmat4(float const* m)
{
    return {dvec4(m), dvec4(m + 4), dvec4(m + 8), dvec4(m + 12)};
}

/// Rounds to the floats of a question.
template <typename Vector>
void store(Vector const& from, float* to)
{
    for (int i = 0; i < from.length(); ++i)
        to[i] = static_cast<float>(from[i]);
}
inline void store(glm::dmat4 const& from, float* to)
{
    for (int i = 0; i < 4; ++i)
        store(from[i], to + 4 * i);
}
}  // namespace testat
