#include "theory/matrices.h"
#include "theory/slips.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace testat::theory {
namespace {
constexpr double rounding = 1e-3;
char const* const axes = "uvw";

bool near(double a, double b)
{
    return std::abs(a - b) <= rounding;
}

bool near(glm::dvec3 const& a, glm::dvec3 const& b)
{
    return near(a.x, b.x) && near(a.y, b.y) && near(a.z, b.z);
}

void last_row(glm::dmat4 const& m, std::vector<Finding>& findings)
{
    bool right = near(m[3][3], 1);
    for (int column = 0; column < 3; ++column)
        right = right && near(m[column][3], 0);
    if (!right)
        findings.push_back(
            {"homogeneous_row",
             {"Die letzte Zeile einer affinen Transformation ist 0 0 0 1: sonst bleibt die homogene "
              "Koordinate eines Punktes nicht 1.",
              "The last row of an affine transformation is 0 0 0 1: otherwise the homogeneous coordinate "
              "of a point does not stay 1."}});
}

/// Names of the columns that are not images of u1, v1, w1.
std::string wrong_columns(glm::dmat3 const& r)
{
    glm::dmat3 const right(solution());
    std::string names;
    for (int i = 0; i < 3; ++i)
        if (!near(r[i], right[i]))
            names += fmt::format("{}{}1", names.empty() ? "" : ", ", axes[i]);
    return names;
}

bool is_orthonormal(glm::dmat3 const& r)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j)
            if (!near(glm::dot(r[i], r[j]), i == j ? 1 : 0))
                return false;
    return true;
}

void handedness(glm::dmat3 const& r, std::vector<Finding>& findings)
{
    if (!is_orthonormal(r))
        findings.push_back({"not_orthonormal",
                            {"Die linke obere 3x3-Matrix ist keine Drehung: ihre Spalten müssen Länge 1 haben und "
                             "aufeinander senkrecht stehen, denn beide Basen sind orthonormal.",
                             "The upper left 3 x 3 matrix is no rotation: its columns must have length 1 and be "
                             "perpendicular, as both bases are orthonormal."}});
    else if (glm::determinant(r) < 0)
        findings.push_back({"handedness",
                            {"Die Determinante der 3x3-Matrix ist -1: sie spiegelt. S1 und S2 sind beide rechtshändig, "
                             "zwischen ihnen vermittelt eine Drehung (Determinante +1).",
                             "The determinant of the 3 x 3 matrix is -1: it mirrors. S1 and S2 are both right-handed, "
                             "and a rotation (determinant +1) leads from one to the other."}});
}

void rotation(glm::dmat3 const& r, std::vector<Finding>& findings)
{
    std::string const columns = wrong_columns(r);
    if (columns.empty())
        return;
    handedness(r, findings);
    findings.push_back(
        {"columns",
         {fmt::format("Falsche Spalten: {}. Die ersten drei Spalten von M sind u1, v1 und w1, ausgedrückt in S2: die "
                      "Skalarprodukte mit u2, v2 und w2.",
                      columns),
          fmt::format("Wrong columns: {}. The first three columns of M are u1, v1 and w1 expressed in S2: their scalar "
                      "products with u2, v2 and w2.",
                      columns)}});
}

void translation(glm::dvec3 const& t, std::vector<Finding>& findings)
{
    glm::dvec3 const right(solution()[3]);
    if (near(t, right))
        return;
    if (near(t, glm::dvec3(0.0)))
        findings.push_back({"no_translation",
                            {"Die Verschiebung fehlt: O1 ist nicht der Ursprung von S2.",
                             "The translation is forgotten: O1 is not the origin of S2."}});
    else if (near(t, -right))
        findings.push_back({"translation_sign",
                            {"Die Verschiebung hat das falsche Vorzeichen.", "The translation has the wrong sign."}});
    else if (glm::dvec3 const origin(systems_of_the_sheet().origin1[3]); near(t, origin))
        findings.push_back({"translation_not_rotated",
                            {"Die letzte Spalte ist O1 in Weltkoordinaten; sie muss O1 in Koordinaten von S2 sein.",
                             "The last column is O1 in world coordinates; it must be O1 in coordinates of S2."}});
    else
        findings.push_back(
            {"translation",
             {"Die Verschiebung stimmt nicht: die letzte Spalte von M sind die Koordinaten von O1 in S2.",
              "The translation is wrong: the last column of M holds the coordinates of O1 in S2."}});
}
}  // namespace

std::vector<Finding> wrong_parts(glm::dmat4 const& matrix)
{
    std::vector<Finding> findings;
    last_row(matrix, findings);
    rotation(glm::dmat3(matrix), findings);
    translation(glm::dvec3(matrix[3]), findings);
    return findings;
}
}  // namespace testat::theory
