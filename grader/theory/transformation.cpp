#include "theory/expression.h"
#include "theory/matrices.h"
#include "theory/slips.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace testat::theory {
namespace {
using Json = nlohmann::ordered_json;
using Factors = std::vector<Factor>;

glm::dmat4 product(Factors const& factors)
{
    glm::dmat4 result(1.0);
    for (auto const& factor : factors)
        result = result * factor.matrix;
    return result;
}

bool is_right(Factors const& factors)
{
    return alike(product(factors), solution());
}

Finding const radians{"radians",
                      {"Ohne Gradzeichen rechnen sin, cos und tan im Bogenmaß. Mit Grad stimmt es: cos(90°).",
                       "Without a degree sign sin, cos and tan take radians. In degrees it is right: cos(90°)."}};

bool is_right_in_degrees(Factors factors)
{
    for (auto& factor : factors)
        factor.matrix = factor.in_degrees;
    return is_right(factors);
}

/// One change of one factor, and what to say if it makes the product right.
struct Change {
    char const* id;
    bool (*apply)(glm::dmat4& factor);  ///< false if there is nothing to change
    Phrase text;                        ///< with the number of the factor
};

bool invert(glm::dmat4& factor)
{
    if (!(std::abs(glm::determinant(factor)) > 1e-12))
        return false;
    factor = glm::inverse(factor);
    return true;
}

bool turn_translation(glm::dmat4& factor)
{
    factor[3] = glm::dvec4(-glm::dvec3(factor[3]), factor[3].w);
    return true;
}

bool transpose(glm::dmat4& factor)
{
    factor = glm::transpose(factor);
    return true;
}

bool leave_out(glm::dmat4& factor)
{
    factor = glm::dmat4(1.0);
    return true;
}

/// What matrices of rotations alone and translations alone have in common comes first.
Change const changes[] = {
    {"translation_sign",
     turn_translation,
     {"Im {}. Faktor hat die Verschiebung das falsche Vorzeichen; sonst stimmt das Produkt.",
      "In factor {} the translation has the wrong sign; otherwise the product is right."}},
    {"factor_inverted",
     invert,
     {"Der {}. Faktor muss invertiert werden; sonst stimmt das Produkt. In die Welt führt die Basis eines Systems, in "
      "das System hinein ihre Inverse.",
      "Factor {} must be inverted; otherwise the product is right. Into the world leads the basis of a system, into "
      "the "
      "system its inverse."}},
    {"factor_transposed",
     transpose,
     {"Der {}. Faktor muss transponiert werden (Spalten statt Zeilen); sonst stimmt das Produkt.",
      "Factor {} must be transposed (columns, not rows); otherwise the product is right."}},
    {"factor_too_many",
     leave_out,
     {"Der {}. Faktor ist zu viel; ohne ihn stimmt das Produkt.",
      "Factor {} is too many; without it the product is right."}},
};

std::optional<Finding> changed_factor(Factors const& factors)
{
    for (auto const& change : changes)
        for (std::size_t i = 0; i < factors.size(); ++i) {
            Factors changed = factors;
            if (change.apply(changed[i].matrix) && is_right(changed))
                return Finding{change.id,
                               {fmt::format(fmt::runtime(change.text.de), i + 1),
                                fmt::format(fmt::runtime(change.text.en), i + 1)}};
        }
    return std::nullopt;
}

std::optional<Finding> changed_order(Factors factors)
{
    std::reverse(factors.begin(), factors.end());
    if (is_right(factors))
        return Finding{
            "order_reversed",
            {"Die Reihenfolge der Faktoren ist umgekehrt: was zuerst geschieht, steht ganz rechts, neben P1.",
             "The order of the factors is reversed: what happens first stands rightmost, beside P1."}};
    std::reverse(factors.begin(), factors.end());
    for (std::size_t i = 0; i < factors.size(); ++i)
        for (std::size_t j = i + 1; j < factors.size(); ++j) {
            Factors changed = factors;
            std::swap(changed[i], changed[j]);
            if (is_right(changed))
                return Finding{"order",
                               {fmt::format("Der {}. und der {}. Faktor sind vertauscht.", i + 1, j + 1),
                                fmt::format("Factors {} and {} are in the wrong order.", i + 1, j + 1)}};
        }
    return std::nullopt;
}

std::optional<Finding> slip_of(glm::dmat4 const& matrix)
{
    for (auto const& slip : slips())
        if (alike(matrix, slip.matrix))
            return slip.finding;
    return std::nullopt;
}

std::string answered(Factor const& factor)
{
    return to_text(factor.matrix);
}

std::string answered(Factors const& factors)
{
    return to_text(product(factors));
}

std::vector<Finding> findings_of(Factor const& factor)
{
    if (!alike(factor.matrix, solution()) && alike(factor.in_degrees, solution()))
        return {radians};
    return diagnose(factor.matrix);
}

std::vector<Finding> findings_of(Factors const& factors)
{
    return diagnose(factors);
}

template <typename Read>
Judgement judge(std::string const& id, Json const& answer, Read read)
{
    Judgement result{id, Verdict::unanswered, "", {}};
    try {
        auto const given = read(answer);
        if (!given)
            return result;
        result.answer = answered(*given);
        result.findings = findings_of(*given);
        result.verdict = result.findings.empty() ? Verdict::right : Verdict::wrong;
    } catch (Refused const& e) {
        result.verdict = Verdict::unreadable;
        result.findings = {{"unreadable", e.why}};
    }
    return result;
}
}  // namespace

std::vector<Finding> diagnose(glm::dmat4 const& matrix)
{
    if (alike(matrix, solution()))
        return {};
    if (auto const slip = slip_of(matrix))
        return {*slip};
    return wrong_parts(matrix);
}

std::vector<Finding> diagnose(Factors const& factors)
{
    if (is_right(factors))
        return {};
    if (is_right_in_degrees(factors))
        return {radians};
    std::vector<Finding> whole = diagnose(product(factors));
    if (factors.size() < 2 || whole.at(0).id == "inverse")
        return whole;
    if (auto const order = changed_order(factors))
        return {*order};
    if (auto const change = changed_factor(factors))
        return {*change};
    return whole;
}

std::vector<Judgement> judge_transformation(Json const& answers)
{
    auto const given = [&](char const* key) { return answers.is_object() ? answers.value(key, Json()) : Json(); };
    return {judge("M", given("M"), read_matrix), judge("factors", given("factors"), read_factors)};
}
}  // namespace testat::theory
