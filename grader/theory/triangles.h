#pragma once
#include "theory/expression.h"

#include <array>
#include <vector>

namespace testat::theory {
/// A triangle in space with texture coordinates, and a point inside.
struct Triangle {
    std::array<Value, 3> corners;  ///< A, B, C
    std::array<Value, 3> uv;       ///< A', B', C'
    Value p;
    std::array<double, 3> lambda;  ///< of p; each at least 0.04, sum 1
    double area = 0;

    /// Of the part that has P in the place of a corner: area * lambda (ratio of heights over the common side).
    double part(int opposite) const { return area * lambda[opposite]; }
};

/// The same ones in each run. None is thin, and no two parts of one are nearly as large.
std::vector<Triangle> const& random_triangles();

/// Points and texture coordinates by name: A B C P, A' B' C'.
Variables variables_of(Triangle const& triangle);

/// What a formula gives for each triangle. Throws Refused if it does not give a `size` of components everywhere,
/// finite.
std::vector<Value> values_of(Expression const& formula, std::vector<Variables> const& variables, int size);

/// Whether they agree but for rounding; never if one is NaN.
bool alike(Value const& a, Value const& b);
}  // namespace testat::theory
