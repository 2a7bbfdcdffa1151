#pragma once
#include "checks/vectors.h"

#include <cmath>

/// Running error analysis (Wilkinson; Higham, Accuracy and Stability of Numerical Algorithms, section 3.3): a
/// calculation in double that knows at every step how far the same calculation in float may be off. What comes out is
/// as large as the conditioning of the very input asks for: cancellation, grazing angles and skew matrices need no
/// cases of theirs.
namespace testat {
/// A number that float arithmetic has come to.
struct Rounded {
    double value = 0;  ///< exact, but for double's roundings
    double error = 0;  ///< the float is off by this at most; infinite where nothing can be said

    // NOLINTNEXTLINE(google-explicit-constructor): a float of a question is exact
    Rounded(double exact = 0) : value(exact) {}
    Rounded(double v, double e) : value(v), error(e) {}

    double lower() const { return value - error; }
    double upper() const { return value + error; }
};

/// Whether something holds in float.
enum class Certainty { no, perhaps, yes };

/// One rounding more: relative to the number, and half of the smallest float, 2^-149. Nothing is lost from an exact
/// zero.
inline Rounded round_once(double value, double error)
{
    if (value == 0 && error == 0)
        return {0, 0};
    double const rounded = error + eps * (std::abs(value) + error) + 0x1p-150;
    return {value, rounded >= 0 ? rounded : HUGE_VAL};  // NaN comes of infinite errors
}

inline Rounded operator-(Rounded a)
{
    return {-a.value, a.error};
}
inline Rounded operator+(Rounded a, Rounded b)
{
    return round_once(a.value + b.value, a.error + b.error);
}
inline Rounded operator-(Rounded a, Rounded b)
{
    return a + -b;
}
inline Rounded operator*(Rounded a, Rounded b)
{
    return round_once(a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
}
/// Nothing can be said of a quotient by what may be zero.
inline Rounded operator/(Rounded a, Rounded b)
{
    double const divisor = std::abs(b.value) - b.error;
    double const quotient = a.value / b.value;
    return round_once(quotient, divisor > 0 ? (a.error + std::abs(quotient) * b.error) / divisor : HUGE_VAL);
}
inline Rounded sqrt(Rounded a)
{
    double const root = std::sqrt(std::max(a.value, 0.0));
    double const above = std::sqrt(std::max(a.upper(), 0.0)) - root;
    double const below = root - std::sqrt(std::max(a.lower(), 0.0));
    return round_once(root, std::max(above, below));
}

inline Certainty is_positive(Rounded a)
{
    return a.lower() > 0 ? Certainty::yes : a.upper() <= 0 ? Certainty::no : Certainty::perhaps;
}

struct RoundedVector {
    Rounded x, y, z;

    glm::dvec3 value() const { return {x.value, y.value, z.value}; }
    /// The length of the longest error there may be.
    double error() const { return glm::length(glm::dvec3(x.error, y.error, z.error)); }
};

inline RoundedVector exact_vector(float const* v)
{
    return {v[0], v[1], v[2]};
}
inline RoundedVector operator+(RoundedVector const& a, RoundedVector const& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline RoundedVector operator-(RoundedVector const& a, RoundedVector const& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline RoundedVector operator*(Rounded a, RoundedVector const& b)
{
    return {a * b.x, a * b.y, a * b.z};
}
inline Rounded dot(RoundedVector const& a, RoundedVector const& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline RoundedVector cross(RoundedVector const& a, RoundedVector const& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Rounded length(RoundedVector const& v)
{
    return sqrt(dot(v, v));
}
/// As GLM does: times one over the length.
inline RoundedVector normalize(RoundedVector const& v)
{
    return Rounded(1) / length(v) * v;
}

/// The linear part of a matrix and its translation. Column-major.
struct RoundedTransform {
    RoundedVector columns[3];
    RoundedVector translation;
};

inline RoundedVector times_direction(RoundedTransform const& m, RoundedVector const& d)
{
    return d.x * m.columns[0] + d.y * m.columns[1] + d.z * m.columns[2];
}
/// Summed up in GLM's order: the first two and the last two.
inline RoundedVector times_position(RoundedTransform const& m, RoundedVector const& p)
{
    return (p.x * m.columns[0] + p.y * m.columns[1]) + (p.z * m.columns[2] + m.translation);
}

/// An affine matrix of a question.
inline RoundedTransform exact_transform(float const* m)
{
    return {{exact_vector(m), exact_vector(m + 4), exact_vector(m + 8)}, exact_vector(m + 12)};
}

/// The transposed linear part, without translation.
inline RoundedTransform transpose(RoundedTransform const& m)
{
    auto const& c = m.columns;
    return {{{c[0].x, c[1].x, c[2].x}, {c[0].y, c[1].y, c[2].y}, {c[0].z, c[1].z, c[2].z}}, {}};
}

/// As glm::inverse does, in its order: cofactors times one over the determinant, the translation by minors of its own.
RoundedTransform inverse(RoundedTransform const& m);
}  // namespace testat
