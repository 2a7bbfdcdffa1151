#pragma once
#include "theory/finding.h"

#include <glm/glm.hpp>

#include <vector>

namespace testat::theory {
/// A whole matrix that comes out of one mistake, and its name.
struct Slip {
    glm::dmat4 matrix;
    Finding finding;
};

/// Mistakes on the way from S1 to S2; the first that gives an answer's matrix explains it. No two give the same matrix,
/// and none the solution.
std::vector<Slip> const& slips();

/// What is wrong with single parts of a matrix that no slip explains: its last row, its 3 x 3 part, its last column.
std::vector<Finding> wrong_parts(glm::dmat4 const& matrix);
}  // namespace testat::theory
