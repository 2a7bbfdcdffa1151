#pragma once
#include "theory/barycentric.h"
#include "theory/triangles.h"

#include <optional>

/// What the judges of formulas share.
namespace testat::theory {
/// Whether there is no answer.
bool is_blank(std::string const& text);

/// The names of the parts: PBC, PCA, PAB for those opposite A, B, C.
constexpr char const* const part_names[] = {"PBC", "PCA", "PAB"};
constexpr char const* const corner_names[] = {"A", "B", "C"};

/// For each triangle what a formula of a coordinate may use: points, the areas F1 to F3, that of all of it as F, and
/// the coordinates.
std::vector<Variables> known_values(Opposite const& opposite);

/// a / b, if it is the same for all triangles.
std::optional<double> constant_ratio(std::vector<Value> const& a, std::vector<Value> const& b);

/// Whether the lists agree for all triangles.
bool alike(std::vector<Value> const& a, std::vector<Value> const& b);

/// f(triangle) for each of them, where it gives a Value or a double.
template <typename F>
std::vector<Value> for_each_triangle(F f)
{
    std::vector<Value> values;
    for (auto const& triangle : random_triangles())
        if constexpr (std::is_same_v<decltype(f(triangle)), double>)
            values.push_back(Value::number(f(triangle)));
        else
            values.push_back(f(triangle));
    return values;
}

/// Judges what has been read by `find`, which gives the findings; no answer where `formula` is blank.
template <typename Find>
Judgement judge_formula(std::string const& id, std::string const& formula, Find find)
{
    Judgement result{id, Verdict::unanswered, "", {}};
    if (is_blank(formula))
        return result;
    result.answer = formula;
    try {
        result.findings = find();
        result.verdict = result.findings.empty() ? Verdict::right : Verdict::wrong;
    } catch (Refused const& e) {
        result.verdict = Verdict::unreadable;
        result.findings = {{"unreadable", e.why}};
    }
    return result;
}
}  // namespace testat::theory
