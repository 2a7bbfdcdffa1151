#include "checks/mistakes/lookups.h"
#include "checks/vectors.h"

namespace testat {
namespace {
/// Where the four texels begin along one axis, and how much the farther ones count.
struct Place {
    int first;
    double weight;
};

/// How a coordinate in texels (0 at the border of the texture) becomes a place.
using Axis = Place (*)(double st);

Place right(double st)
{
    double const s = st - 0.5;
    return {static_cast<int>(std::floor(s)), s - std::floor(s)};
}

Place without_shift(double st)
{
    return {static_cast<int>(std::floor(st)), st - std::floor(st)};
}

Place wrong_way(double st)
{
    return without_shift(st + 0.5);
}

Place cast(double st)
{
    double const s = st - 0.5;
    return {static_cast<int>(s), s - std::trunc(s)};
}

/// The texel by conversion, the weight by glm::fract.
Place cast_with_fraction(double st)
{
    double const s = st - 0.5;
    return {static_cast<int>(s), s - std::floor(s)};
}

Place cast_without_shift(double st)
{
    return cast(st + 0.5);
}

Place cast_with_fraction_without_shift(double st)
{
    return cast_with_fraction(st + 0.5);
}

Place nearest(double st)
{
    return {static_cast<int>(std::floor(st)), 0};
}

Place lower(double st)
{
    return {right(st).first, 0};
}

Place exchanged(double st)
{
    Place const place = right(st);
    return {place.first, 1 - place.weight};
}

/// Conversion, and one less below zero: right but for whole numbers.
Place one_less_below_zero(double st)
{
    double const s = st - 0.5;
    return {static_cast<int>(s) - (s < 0 ? 1 : 0), s - std::floor(s)};
}

struct Rule {
    Axis along_s = right;
    Axis along_t = right;
    bool exchange_weights = false;
    bool size_of_level_zero = false;
    bool texels_of_level_zero = false;
    bool exchange_sides = false;
    int smaller_by = 0;                ///< what is taken from the size before uv is scaled by it
    std::optional<double> alpha = {};  ///< of every result
};

glm::dvec4 interpolate(TextureData const& texture, int level, Place s, Place t)
{
    auto const row = [&](int y) {
        return glm::mix(texel(texture, level, s.first, y), texel(texture, level, s.first + 1, y), s.weight);
    };
    return glm::mix(row(t.first), row(t.first + 1), t.weight);
}

Model model(Rule const& rule)
{
    WrongLookup const wrong = [=](TextureData const& texture, LookupQuestion const& q, glm::dvec2 uv, glm::dvec2) {
        glm::ivec2 size = level_size(texture, rule.size_of_level_zero ? 0 : q.level) - rule.smaller_by;
        if (rule.exchange_sides)
            std::swap(size.x, size.y);
        Place s = rule.along_s(uv.x * size.x);
        Place t = rule.along_t(uv.y * size.y);
        if (rule.exchange_weights)
            std::swap(s.weight, t.weight);
        glm::dvec4 colour = interpolate(texture, rule.texels_of_level_zero ? 0 : q.level, s, t);
        colour.a = rule.alpha.value_or(colour.a);
        return std::optional(colour);
    };
    return lookup_model(wrong, rule.smaller_by);
}

Rule both(Axis axis)
{
    return {axis, axis};
}

Rule smaller_by_one(Axis axis)
{
    return {axis, axis, false, false, false, false, 1, {}};
}

Rule with_alpha(double alpha)
{
    return {right, right, false, false, false, false, 0, alpha};
}
}  // namespace

void add_evaluate_bilinear_mistakes(std::vector<Mistake>& mistakes)
{
    auto const add = [&](char const* id, std::vector<Rule> const& rules) {
        Mistake mistake{id, Function::evaluate_bilinear, {}};
        for (auto const& rule : rules)
            mistake.models.push_back(model(rule));
        mistakes.push_back(std::move(mistake));
    };
    add("bilinear_without_shift", {both(without_shift)});
    add("bilinear_shifts_the_wrong_way", {both(wrong_way)});
    add("bilinear_casts", {both(cast), both(cast_with_fraction)});
    add("bilinear_casts_without_shift", {both(cast_without_shift), both(cast_with_fraction_without_shift)});
    add("bilinear_off_at_negative_centres", {both(one_less_below_zero)});
    add("bilinear_one_axis", {{right, nearest}, {right, lower}, {nearest, right}, {lower, right}});
    add("bilinear_is_nearest", {both(nearest), both(lower)});
    add("bilinear_exchanges_weights",
        {both(exchanged), {exchanged, right}, {right, exchanged}, {right, right, true}, {exchanged, exchanged, true}});
    add("bilinear_ignores_level", {{right, right, false, false, true}, {right, right, false, true, true}});
    add("bilinear_size_of_level_zero", {{right, right, false, true}});
    add("bilinear_swaps_width_and_height", {{right, right, false, false, false, true}});
    add("bilinear_scales_by_size_minus_one",
        {smaller_by_one(right), smaller_by_one(without_shift), smaller_by_one(cast), smaller_by_one(cast_without_shift),
         smaller_by_one(cast_with_fraction_without_shift)});
    add("bilinear_loses_alpha", {with_alpha(0), with_alpha(1)});
}
}  // namespace testat
