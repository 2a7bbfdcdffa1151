#include "theory/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace testat::theory {
namespace {
std::string name_of(int corner)
{
    return std::string("lambda_") + corner_names[corner];
}

/// "F2" for the part opposite that corner.
std::string part_of(int corner, Opposite const& opposite)
{
    return fmt::format("F{}", std::find(opposite.begin(), opposite.end(), corner) - opposite.begin() + 1);
}

std::vector<Value> coordinate(int corner)
{
    return for_each_triangle([&](Triangle const& t) { return t.lambda[corner]; });
}

Phrase belongs(int corner, Opposite const& opposite)
{
    std::string const part = part_of(corner, opposite);
    return {fmt::format("Zur Ecke {} gehört das Teildreieck, das ihr gegenüberliegt: {} ({}).", corner_names[corner],
                        part, part_names[corner]),
            fmt::format("To the corner {} belongs the part that lies opposite: {} ({}).", corner_names[corner], part,
                        part_names[corner])};
}

Finding exchanged(int corner, int other, Opposite const& opposite)
{
    Phrase const rule = belongs(corner, opposite);
    return {"exchanged",
            {fmt::format("Das ist {}. {}", name_of(other), rule.de),
             fmt::format("This is {}. {}", name_of(other), rule.en)}};
}

Finding undivided(int corner, int found, Opposite const& opposite)
{
    Phrase more;
    if (found != corner)
        more = belongs(corner, opposite);
    return {"not_divided",
            {fmt::format("Es wird nicht durch die Fläche des ganzen Dreiecks geteilt, F1 + F2 + F3. {}", more.de),
             fmt::format("It is not divided by the area of the whole triangle, F1 + F2 + F3. {}", more.en)}};
}

Finding scaled(double ratio)
{
    if (std::abs(ratio - 2) < 1e-5 || std::abs(ratio - 0.5) < 1e-5)
        return {
            "half",
            {fmt::format("Ein Faktor 1/2 steht an der falschen Stelle: das ist das {:.4g}-Fache. In Zähler und Nenner "
                         "muss dieselbe Art Fläche stehen.",
                         ratio),
             fmt::format("A factor 1/2 is in the wrong place: this is {:.4g} times the coordinate. Numerator and "
                         "denominator must be areas of the same kind.",
                         ratio)}};
    return {"factor",
            {fmt::format("Das ist das {:.4g}-Fache der Koordinate.", ratio),
             fmt::format("This is {:.4g} times the coordinate.", ratio)}};
}

std::optional<Finding> special_case(std::vector<Value> const& values, int corner)
{
    if (alike(values, for_each_triangle([&](Triangle const& t) { return 1 - t.lambda[corner]; })))
        return Finding{"complement",
                       {"Das ist 1 minus die Koordinate: die Anteile der beiden anderen Teildreiecke.",
                        "This is 1 minus the coordinate: the shares of the other two parts."}};
    if (alike(values, for_each_triangle([&](Triangle const& t) { return 1 / t.lambda[corner]; })))
        return Finding{"upside_down",
                       {"Zähler und Nenner sind vertauscht.", "Numerator and denominator are exchanged."}};
    for (int i = 0; i < 3; ++i)
        if (alike(values, for_each_triangle([&](Triangle const& t) { return t.lambda[i] / (1 - t.lambda[i]); })))
            return Finding{"divided_by_the_rest",
                           {"Geteilt wird durch die Fläche des ganzen Dreiecks, nicht nur durch die der beiden anderen "
                            "Teile.",
                            "Divide by the area of the whole triangle, not only by that of the other two parts."}};
    return std::nullopt;
}

std::vector<Finding> findings_of(std::vector<Value> const& values, int corner, Opposite const& opposite)
{
    if (alike(values, coordinate(corner)))
        return {};
    for (int other = 0; other < 3; ++other)
        if (alike(values, coordinate(other)))
            return {exchanged(corner, other, opposite)};
    for (int i : {corner, 0, 1, 2})
        if (constant_ratio(values, for_each_triangle([&](Triangle const& t) { return t.part(i); })))
            return {undivided(corner, i, opposite)};
    if (auto const ratio = constant_ratio(values, coordinate(corner)))
        return {scaled(*ratio)};
    if (auto const finding = special_case(values, corner))
        return {*finding};
    Phrase const rule = belongs(corner, opposite);
    return {{"wrong",
             {"Das ist nicht die Fläche des Teildreiecks, geteilt durch die ganze. " + rule.de,
              "This is not the area of the part divided by the whole. " + rule.en}}};
}

using Formulas = std::array<std::optional<Expression>, 3>;

/// Coordinates that come from the points and areas alone, or from others that do.
std::array<bool, 3> grounded(Formulas const& formulas)
{
    std::array<bool, 3> known{};
    auto const stands = [&](std::string const& name) {
        for (int i = 0; i < 3; ++i)
            if (name == name_of(i))
                return known[i] || !formulas[i];
        return true;
    };
    for (int pass = 0; pass < 3; ++pass)
        for (int i = 0; i < 3; ++i)
            if (formulas[i]) {
                auto const names = formulas[i]->names();
                known[i] = std::all_of(names.begin(), names.end(), [&](auto const& n) { return stands(n); });
            }
    return known;
}

Formulas parse(std::array<std::string, 3> const& texts)
{
    Formulas formulas;
    for (int i = 0; i < 3; ++i)
        try {
            if (!is_blank(texts[i]))
                formulas[i] = Expression(texts[i]);
        } catch (Refused const&) {
            // judge_formula says so.
        }
    return formulas;
}

Finding const circular{
    "circular",
    {"Die Koordinaten sind im Kreis durcheinander definiert; mindestens zwei müssen aus Flächen folgen.",
     "The coordinates are defined by each other, in a circle; at least two must follow from areas."}};

/// Appends to the first wrong one that the answers do not add up to 1.
void check_sum(std::vector<Judgement>& judgements, std::array<std::vector<Value>, 3> const& values)
{
    bool one = true;
    for (auto const& of_coordinate : values)
        if (of_coordinate.empty())
            return;
    for (std::size_t i = 0; i < values[0].size(); ++i) {
        double const sum = values[0][i].v[0] + values[1][i].v[0] + values[2][i].v[0];
        one = one && std::abs(sum - 1) < 1e-6;
    }
    auto const wrong = std::find_if(judgements.begin(), judgements.end(),
                                    [](Judgement const& j) { return j.verdict == Verdict::wrong; });
    if (!one && wrong != judgements.end())
        wrong->findings.push_back({"sum",
                                   {"Eine Probe, die das zeigt: die drei Koordinaten müssen zusammen 1 ergeben.",
                                    "A test that shows it: the three coordinates must add up to 1."}});
}
}  // namespace

std::vector<Judgement> judge_coordinates(std::array<std::string, 3> const& formulas, Opposite const& opposite)
{
    auto const variables = known_values(opposite);
    auto const stands = grounded(parse(formulas));
    std::array<std::vector<Value>, 3> values;
    std::vector<Judgement> judgements;
    for (int i = 0; i < 3; ++i)
        judgements.push_back(judge_formula(name_of(i), formulas[i], [&]() -> std::vector<Finding> {
            Expression const formula(formulas[i]);
            if (!stands[i])
                return {circular};
            values[i] = values_of(formula, variables, 1);
            return findings_of(values[i], i, opposite);
        }));
    check_sum(judgements, values);
    return judgements;
}
}  // namespace testat::theory
