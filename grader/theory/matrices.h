#pragma once
#include "theory/finding.h"

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

/// The first theory question: P2 = M P1, from S1 = (O1, u1, v1, w1) to S2 = (O2, u2, v2, w2).
namespace testat::theory {
/// The two systems of the sheet, as 4 x 4 matrices.
struct Systems {
    glm::dmat4 basis1;  ///< columns u1, v1, w1 in world coordinates
    glm::dmat4 basis2;
    glm::dmat4 origin1;  ///< translation by O1; O2 is the world's origin
};
Systems systems_of_the_sheet();

/// M = basis2^-1 * origin1 * basis1: out of S1 into the world, and from there into S2.
glm::dmat4 solution();

/// A matrix of a product, with what a student may have meant if angles have lost their degree sign.
struct Factor {
    glm::dmat4 matrix{1.0};
    glm::dmat4 in_degrees{1.0};
};

/// What was answered; throws Refused for what is no such answer. Nothing if there is none: null, empty, or texts
/// without a character. Four rows of four numbers or texts such as "cos(90°)".
std::optional<Factor> read_matrix(nlohmann::ordered_json const& answer);

/// At most sixteen factors as written from left to right: {"translate": [x, y, z]}, {"scale": ...},
/// {"rotate": {"axis": "u" or [x, y, z], "degrees": a}}, {"matrix": rows}; with "inverse": true, and a "meaning" that
/// nobody judges.
std::optional<std::vector<Factor>> read_factors(nlohmann::ordered_json const& answer);

/// Equal but for rounding to three decimals; never if an entry is NaN.
bool alike(glm::dmat4 const& a, glm::dmat4 const& b);

/// "[1 0 0 4; 0 1 0 5; 0 0 1 6; 0 0 0 1]"
std::string to_text(glm::dmat4 const& matrix);

/// The names of what is wrong with a matrix; nothing if it is right.
std::vector<Finding> diagnose(glm::dmat4 const& matrix);

/// The same of a product. Names the factor that spoils it where one change makes it right.
std::vector<Finding> diagnose(std::vector<Factor> const& factors);

/// "M" and "factors" of the answers; never throws for what a student has written.
std::vector<Judgement> judge_transformation(nlohmann::ordered_json const& answers);
}  // namespace testat::theory
