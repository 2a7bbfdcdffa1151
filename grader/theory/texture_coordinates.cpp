#include "theory/formula.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat::theory {
namespace {
using Weights = std::array<double, 3>;

Value weighted(Triangle const& t, Weights const& w)
{
    Value sum = Value::pair(0, 0);
    for (int i = 0; i < 3; ++i)
        for (int component : {0, 1})
            sum.v[component] += w[i] * t.uv[i].v[component];
    return sum;
}

std::vector<Value> right_values()
{
    return for_each_triangle([](Triangle const& t) { return weighted(t, t.lambda); });
}

std::optional<Finding> weighted_by_wrong_corners(std::vector<Value> const& values)
{
    Opposite order{0, 1, 2};
    while (std::next_permutation(order.begin(), order.end()))
        if (alike(values, for_each_triangle([&](Triangle const& t) {
                      return weighted(t, {t.lambda[order[0]], t.lambda[order[1]], t.lambda[order[2]]});
                  })))
            return Finding{
                "wrong_corners",
                {"Die Texturkoordinaten sind mit den Gewichten falscher Ecken multipliziert: zu A' gehört "
                 "lambda_A, zu B' lambda_B, zu C' lambda_C.",
                 "The texture coordinates are multiplied by weights of the wrong corners: lambda_A belongs to "
                 "A', lambda_B to B', lambda_C to C'."}};
    return std::nullopt;
}

std::optional<Finding> special_case(std::vector<Value> const& values)
{
    if (alike(values, for_each_triangle([](Triangle const& t) {
                  Value const p = weighted(t, t.lambda);
                  return Value::pair(p.v[1], p.v[0]);
              })))
        return Finding{"uv_exchanged", {"u und v sind vertauscht.", "u and v are exchanged."}};
    if (constant_ratio(values, for_each_triangle([](Triangle const& t) { return weighted(t, {1, 1, 1}); })))
        return Finding{
            "not_weighted",
            {"Die Texturkoordinaten der Ecken sind nicht gewichtet: P' hängt so nicht von P ab.",
             "The texture coordinates of the corners are not weighted: like this, P' does not depend on P."}};
    if (constant_ratio(values, for_each_triangle([](Triangle const& t) {
                           return weighted(t, {t.part(0), t.part(1), t.part(2)});
                       })))
        return Finding{
            "not_divided",
            {"Die Gewichte sind Flächen, nicht baryzentrische Koordinaten: sie müssen noch durch die Fläche des "
             "ganzen Dreiecks geteilt werden.",
             "The weights are areas, not barycentric coordinates: they must still be divided by the area of "
             "the whole triangle."}};
    return std::nullopt;
}

std::vector<Finding> findings_of(std::vector<Value> const& values)
{
    if (alike(values, right_values()))
        return {};
    if (auto const finding = weighted_by_wrong_corners(values))
        return {*finding};
    if (auto const finding = special_case(values))
        return {*finding};
    if (auto const ratio = constant_ratio(values, right_values()))
        return {{"factor",
                 {fmt::format("Das ist das {:.4g}-Fache von P'.", *ratio),
                  fmt::format("This is {:.4g} times P'.", *ratio)}}};
    return {{"wrong",
             {"Das ist nicht P'. Gesucht ist die Summe der Texturkoordinaten der Ecken, jede mit der baryzentrischen "
              "Koordinate ihrer Ecke multipliziert.",
              "This is not P'. Wanted is the sum of the texture coordinates of the corners, each multiplied by the "
              "barycentric coordinate of its corner."}}};
}

std::vector<Value> joined(std::vector<Value> u, std::vector<Value> const& v)
{
    for (std::size_t i = 0; i < u.size(); ++i)
        u[i] = Value::pair(u[i].v[0], v[i].v[0]);
    return u;
}

/// Blank where nothing is answered at all.
std::string shown(std::vector<std::string> const& formulas)
{
    if (std::all_of(formulas.begin(), formulas.end(), is_blank))
        return "";
    return formulas.size() == 1 ? formulas[0] : fmt::format("u = {}, v = {}", formulas[0], formulas[1]);
}
}  // namespace

Judgement judge_texture_coordinates(std::vector<std::string> const& formulas, Opposite const& opposite)
{
    return judge_formula("P'", shown(formulas), [&] {
        auto const variables = known_values(opposite);
        auto const values = [&](std::size_t i, int size) {
            return values_of(Expression(formulas[i]), variables, size);
        };
        return findings_of(formulas.size() == 1 ? values(0, 2) : joined(values(0, 1), values(1, 1)));
    });
}
}  // namespace testat::theory
