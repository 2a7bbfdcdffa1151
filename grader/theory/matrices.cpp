#include "theory/matrices.h"

#include <fmt/format.h>

#include <cmath>

namespace testat::theory {
namespace {
glm::dmat4 basis(glm::dvec3 const& u, glm::dvec3 const& v, glm::dvec3 const& w)
{
    return {glm::dvec4(u, 0), glm::dvec4(v, 0), glm::dvec4(w, 0), {0, 0, 0, 1}};
}

glm::dmat4 translation(glm::dvec3 const& t)
{
    glm::dmat4 result(1.0);
    result[3] = glm::dvec4(t, 1);
    return result;
}
}  // namespace

Systems systems_of_the_sheet()
{
    return {basis({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), basis({0, 0, -1}, {1, 0, 0}, {0, -1, 0}), translation({-2, 1, -1})};
}

glm::dmat4 solution()
{
    auto const [basis1, basis2, origin1] = systems_of_the_sheet();
    return glm::inverse(basis2) * origin1 * basis1;
}

bool alike(glm::dmat4 const& a, glm::dmat4 const& b)
{
    constexpr double rounding = 1e-3;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(a[column][row] - b[column][row]) <= rounding))
                return false;
    return true;
}

std::string to_text(glm::dmat4 const& matrix)
{
    std::string text;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            double const x = matrix[column][row];
            text += fmt::format("{}{:.4g}", column > 0 ? " " : row > 0 ? "; " : "[", std::abs(x) < 1e-9 ? 0 : x);
        }
    return text + "]";
}
}  // namespace testat::theory
