#include "theory/formula.h"

#include <fmt/format.h>

#include <cmath>

namespace testat::theory {
namespace {
bool near(double a, double b)
{
    return std::abs(a - b) < 1e-5;
}

std::vector<Value> part(int opposite)
{
    return for_each_triangle([&](Triangle const& t) { return t.part(opposite); });
}

std::vector<Value> absolute(std::vector<Value> values)
{
    for (auto& value : values)
        value.v[0] = std::abs(value.v[0]);
    return values;
}

std::vector<Value> squared(std::vector<Value> values)
{
    for (auto& value : values)
        value.v[0] *= value.v[0];
    return values;
}

Finding wrong_factor(double ratio, char const* triangle)
{
    if (near(ratio, 2))
        return {
            "half_missing",
            {fmt::format("Der Faktor 1/2 fehlt: die Länge des Kreuzprodukts ist die Fläche des Parallelogramms, das "
                         "Dreieck {} ist die Hälfte.",
                         triangle),
             fmt::format("The factor 1/2 is missing: the length of the cross product is the area of the "
                         "parallelogram, the triangle {} is half of it.",
                         triangle)}};
    if (near(ratio, -1))
        return {"sign",
                {"Das Vorzeichen ist falsch: eine Fläche ist nicht negativ.",
                 "The sign is wrong: an area is not negative."}};
    return {"factor",
            {fmt::format("Das ist das {:.4g}-Fache der Fläche von {}.", ratio, triangle),
             fmt::format("This is {:.4g} times the area of {}.", ratio, triangle)}};
}

/// Names a part that the values have to do with.
std::optional<Finding> finding_of_part(std::vector<Value> const& values, int opposite)
{
    char const* const name = part_names[opposite];
    auto const right = part(opposite);
    if (auto const ratio = constant_ratio(values, right))
        return wrong_factor(*ratio, name);
    if (constant_ratio(absolute(values), right))
        return Finding{
            "sign_varies",
            {fmt::format("Der Betrag passt zum Dreieck {}, aber das Vorzeichen wechselt mit der Lage des "
                         "Dreiecks; eine Fläche ist nicht negativ.",
                         name),
             fmt::format("The absolute value fits the triangle {}, but the sign changes with how the triangle "
                         "lies; an area is not negative.",
                         name)}};
    if (constant_ratio(values, squared(right)))
        return Finding{
            "squared",
            {fmt::format("Das ist das Quadrat der Fläche von {} (bis auf einen Faktor): die Wurzel fehlt.", name),
             fmt::format("This is the square of the area of {} (but for a factor): the root is missing.", name)}};
    return std::nullopt;
}

Finding unknown_area(std::vector<Value> const& values)
{
    auto const whole = for_each_triangle([](Triangle const& t) { return t.area; });
    if (constant_ratio(absolute(values), whole))
        return {"whole_triangle",
                {"Das ist das ganze Dreieck ABC (bis auf einen Faktor); ein Teildreieck hat P als Ecke.",
                 "This is the whole triangle ABC (but for a factor); a part has P as a corner."}};
    for (int i = 0; i < 3; ++i)
        if (alike(values, for_each_triangle([&](Triangle const& t) { return t.area - t.part(i); })))
            return {"two_parts", {"Das sind zwei Teildreiecke zusammen.", "These are two of the parts together."}};
    return {
        "no_part",
        {"Das ist keine Fläche eines Teildreiecks. Die Fläche ist der halbe Betrag des Kreuzprodukts zweier Kanten, "
         "die "
         "in derselben Ecke beginnen, und P ist eine Ecke.",
         "This is no area of a part. The area is half the length of the cross product of two edges that begin in the "
         "same corner, and P is a corner."}};
}
}  // namespace

JudgedArea judge_area(std::string const& id, std::string const& formula)
{
    std::optional<int> opposite;
    auto const findings = [&]() -> std::vector<Finding> {
        std::vector<Variables> variables;
        for (auto const& triangle : random_triangles())
            variables.push_back(variables_of(triangle));
        auto const values = values_of(Expression(formula), variables, 1);
        for (int i = 0; i < 3; ++i)
            if (alike(values, part(i)))
                return opposite = i, std::vector<Finding>();
        for (int i = 0; i < 3; ++i)
            if (auto const finding = finding_of_part(values, i))
                return opposite = i, std::vector<Finding>{*finding};
        return {unknown_area(values)};
    };
    Judgement judgement = judge_formula(id, formula, findings);
    return {std::move(judgement), opposite};
}
}  // namespace testat::theory
