#pragma once
#include "theory/finding.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

/// The second theory question: barycentric coordinates of P in the triangle ABC by areas, and from them P'.
namespace testat::theory {
/// Which corner the part of area F1, F2, F3 lies opposite: 0 to 2 for A to C, so that 0 is the triangle PBC.
using Opposite = std::array<int, 3>;

/// "F1" to "F3", "lambda_A" to "lambda_C" and "P'" of the answers; never throws for what a student has written. Only
/// the sheet's figure says which triangle F1 is: the answers' own areas tell, and where they do not, what fits the
/// coordinates best. One mistake counts once: formulas are evaluated with the right values of what others give.
std::vector<Judgement> judge_barycentric(nlohmann::ordered_json const& answers);

/// What an area's formula is: its judgement, and which part it means even if it is not quite right.
struct JudgedArea {
    Judgement judgement;
    std::optional<int> opposite;
};

/// These take formulas as texts; one that is blank is no answer.
JudgedArea judge_area(std::string const& id, std::string const& formula);
std::vector<Judgement> judge_coordinates(std::array<std::string, 3> const& formulas, Opposite const& opposite);
/// One formula for (u, v), or one each.
Judgement judge_texture_coordinates(std::vector<std::string> const& formulas, Opposite const& opposite);
}  // namespace testat::theory
