#include "theory/slips.h"

#include "theory/matrices.h"

#include <fmt/format.h>

namespace testat::theory {
namespace {
/// A matrix without its translation.
glm::dmat4 rotation_of(glm::dmat4 matrix)
{
    matrix[3] = {0, 0, 0, 1};
    return matrix;
}

glm::dmat4 with_translation(glm::dmat4 matrix, glm::dmat4 const& other)
{
    matrix[3] = other[3];
    return matrix;
}

glm::dmat4 scaling(double u, double v, double w)
{
    return {{u, 0, 0, 0}, {0, v, 0, 0}, {0, 0, w, 0}, {0, 0, 0, 1}};
}

/// Another point of view: which way, rows or columns.
std::vector<Slip> of_the_whole()
{
    glm::dmat4 const m = solution();
    return {
        {glm::inverse(m),
         {"inverse",
          {"Das ist die Inverse: sie führt von S2 nach S1. Gesucht ist M mit P2 = M · P1.",
           "This is the inverse: it leads from S2 to S1. Wanted is M with P2 = M · P1."}}},
        {glm::transpose(m),
         {"transposed",
          {"Das ist die Transponierte, wie man sie für Zeilenvektoren bräuchte (P1 · M). Bei P2 = M · P1 stehen Bilder "
           "der Basisvektoren und Verschiebung in den Spalten, und die letzte Zeile ist 0 0 0 1.",
           "This is the transpose, as row vectors would need it (P1 · M). With P2 = M · P1 the images of the basis "
           "vectors and the translation are columns, and the last row is 0 0 0 1."}}},
        {glm::transpose(glm::inverse(m)),
         {"transposed_inverse",
          {"Das ist die Transponierte der Inversen: von S2 nach S1, und für Zeilenvektoren.",
           "This is the transpose of the inverse: from S2 to S1, and for row vectors."}}},
    };
}

std::vector<Slip> of_the_translation()
{
    glm::dmat4 const m = solution();
    auto const [basis1, basis2, origin1] = systems_of_the_sheet();
    return {
        {rotation_of(m),
         {"no_translation",
          {"Die Verschiebung fehlt: die Drehung stimmt, aber O1 ist nicht der Ursprung von S2.",
           "The translation is forgotten: the rotation is right, but O1 is not the origin of S2."}}},
        {with_translation(m, glm::inverse(basis2) * glm::inverse(origin1)),
         {"translation_sign",
          {"Die Verschiebung hat das falsche Vorzeichen: von S1 in die Welt wird um +O1 verschoben (P = O1 + ...), "
           "nicht "
           "um -O1.",
           "The translation has the wrong sign: from S1 into the world it is by +O1 (P = O1 + ...), not by -O1."}}},
        {with_translation(m, origin1),
         {"translation_not_rotated",
          {"Die Verschiebung ist O1 in Weltkoordinaten. Sie muss mit in das System S2 gedreht werden: die letzte "
           "Spalte "
           "sind die Koordinaten von O1 in S2.",
           "The translation is O1 in world coordinates. It must be rotated into S2, too: the last column holds the "
           "coordinates of O1 in S2."}}},
        {with_translation(m, glm::inverse(origin1)),
         {"translation_not_rotated_and_sign",
          {"Die Verschiebung ist -O1 in Weltkoordinaten: sie muss mit in das System S2 gedreht werden, und ihr "
           "Vorzeichen "
           "stimmt nicht.",
           "The translation is -O1 in world coordinates: it must be rotated into S2, too, and its sign is wrong."}}},
        {with_translation(m, glm::inverse(basis1) * origin1),
         {"translation_in_s1",
          {"Die Verschiebung ist in Koordinaten von S1 angegeben, wird aber erst nach der Drehung addiert. Entweder "
           "sind "
           "die beiden Schritte vertauscht, oder O1 muss in Koordinaten von S2 umgerechnet werden.",
           "The translation is given in coordinates of S1, but added after the rotation. Either the two steps are in "
           "the "
           "wrong order, or O1 must be converted to coordinates of S2."}}},
    };
}

std::vector<Slip> of_the_rotation()
{
    glm::dmat4 const m = solution();
    auto const [basis1, basis2, origin1] = systems_of_the_sheet();
    Phrase const not_rotated{
        "Es wird nur verschoben. Die Achsen von S1 und S2 zeigen in verschiedene Richtungen: die "
        "Drehung von S1 nach S2 fehlt.",
        "This only translates. The axes of S1 and S2 point in different directions: the rotation "
        "from S1 to S2 is forgotten."};
    return {
        {origin1, {"no_rotation", not_rotated}},
        {with_translation(glm::dmat4(1.0), m), {"no_rotation", not_rotated}},
        {glm::inverse(origin1), {"no_rotation", not_rotated}},
        {origin1 * basis1,
         {"ends_in_the_world",
          {"Das führt von S1 nur bis in Weltkoordinaten. Es fehlt der Schritt nach S2: die Inverse der Basis von S2, "
           "von "
           "links multipliziert.",
           "This leads from S1 into world coordinates only. The step into S2 is missing: the inverse of the basis of "
           "S2, multiplied from the left."}}},
        {glm::inverse(basis2) * origin1,
         {"starts_in_the_world",
          {"Das führt von Weltkoordinaten nach S2. Es fehlt der erste Schritt: aus S1 in die Welt, mit der Basis von "
           "S1 "
           "ganz rechts im Produkt.",
           "This leads from world coordinates to S2. The first step is missing: out of S1 into the world, with the "
           "basis of S1 as the rightmost factor."}}},
        {basis2 * origin1 * basis1,
         {"basis2_not_inverted",
          {"Die Basis von S2 ist nicht invertiert: die Matrix mit den Spalten u2, v2, w2 führt von S2 in die Welt. "
           "Nach "
           "S2 hinein führt ihre Inverse (die Transponierte).",
           "The basis of S2 is not inverted: the matrix with the columns u2, v2, w2 leads from S2 into the world. Into "
           "S2 leads its inverse (its transpose)."}}},
        {glm::inverse(basis2) * origin1 * glm::inverse(basis1),
         {"basis1_inverted",
          {"Die Basis von S1 ist invertiert: aus S1 in die Welt führt die Matrix mit den Spalten u1, v1, w1 selbst.",
           "The basis of S1 is inverted: out of S1 into the world leads the matrix with the columns u1, v1, w1 "
           "itself."}}},
        {basis2 * origin1 * glm::inverse(basis1),
         {"bases_inverted_the_wrong_way",
          {"Genau die falsche Basis ist invertiert: in die Welt führt die Basis von S1, nach S2 die Inverse der Basis "
           "von "
           "S2.",
           "Just the wrong basis is inverted: into the world leads the basis of S1, into S2 the inverse of that of "
           "S2."}}},
        {basis1 * origin1 * glm::inverse(basis2),
         {"order_reversed",
          {"Die Reihenfolge der Faktoren ist umgekehrt: was zuerst geschieht, steht ganz rechts, neben P1.",
           "The order of the factors is reversed: what happens first stands rightmost, beside P1."}}},
    };
}

/// One axis the wrong way round makes the system left-handed.
std::vector<Slip> of_one_sign()
{
    glm::dmat4 const m = solution();
    char const* const axes = "uvw";
    std::vector<Slip> slips;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 s(1.0);
        s[i] = -1;
        glm::dmat4 const mirror = scaling(s.x, s.y, s.z);
        Phrase const left{
            fmt::format("Das Vorzeichen der {}-Achse stimmt nicht. Die Determinante ist damit -1, das Bild eines "
                        "Rechtssystems ein Linkssystem; S1 und S2 sind beide rechtshändig.",
                        axes[i]),
            fmt::format(
                "The sign of the {} axis is wrong. That makes the determinant -1 and the image of a right-handed "
                "system left-handed; S1 and S2 are both right-handed.",
                axes[i])};
        slips.push_back({m * mirror, {"axis_sign", left}});
        slips.push_back({mirror * m, {"axis_sign", left}});
        glm::dmat4 moved = m;
        moved[3][i] = -moved[3][i];
        slips.push_back({moved,
                         {"component_sign",
                          {fmt::format("In der Verschiebung stimmt das Vorzeichen der {}-Komponente nicht.", axes[i]),
                           fmt::format("In the translation the sign of the {} component is wrong.", axes[i])}}});
    }
    return slips;
}

void append_new(std::vector<Slip>& all, std::vector<Slip> const& more)
{
    for (auto const& slip : more) {
        bool known = alike(slip.matrix, solution());
        for (auto const& other : all)
            known = known || alike(slip.matrix, other.matrix);
        if (!known)
            all.push_back(slip);
    }
}
}  // namespace

std::vector<Slip> const& slips()
{
    static std::vector<Slip> const all = [] {
        std::vector<Slip> result;
        for (auto const& more : {of_the_whole(), of_the_translation(), of_the_rotation(), of_one_sign()})
            append_new(result, more);
        return result;
    }();
    return all;
}
}  // namespace testat::theory
