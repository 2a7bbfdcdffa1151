#include "checks/mistakes/lookups.h"
#include "checks/vectors.h"

#include <algorithm>

namespace testat {
namespace {
using Value = std::optional<glm::dvec4>;
using Filter = glm::dvec4 (*)(TextureData const&, int level, glm::dvec2 uv);
/// S for a footprint in uv, on a texture of this size.
using Footprint = double (*)(glm::dvec2 dudv, glm::ivec2 size);

double larger_side(glm::dvec2 dudv, glm::ivec2 size)
{
    return std::max(dudv.x * size.x, dudv.y * size.y);
}

double smaller_side(glm::dvec2 dudv, glm::ivec2 size)
{
    return std::min(dudv.x * size.x, dudv.y * size.y);
}

double in_uv(glm::dvec2 dudv, glm::ivec2)
{
    return std::max(dudv.x, dudv.y);
}

double width_only(glm::dvec2 dudv, glm::ivec2 size)
{
    return dudv.x * size.x;
}

double height_only(glm::dvec2 dudv, glm::ivec2 size)
{
    return dudv.y * size.y;
}

double by_width(glm::dvec2 dudv, glm::ivec2 size)
{
    return std::max(dudv.x, dudv.y) * size.x;
}

double by_height(glm::dvec2 dudv, glm::ivec2 size)
{
    return std::max(dudv.x, dudv.y) * size.y;
}

double sum_of_sides(glm::dvec2 dudv, glm::ivec2 size)
{
    return dudv.x * size.x + dudv.y * size.y;
}

double mean_of_sides(glm::dvec2 dudv, glm::ivec2 size)
{
    return sum_of_sides(dudv, size) / 2;
}

double diagonal(glm::dvec2 dudv, glm::ivec2 size)
{
    return glm::length(dudv * glm::dvec2(size));
}

double area(glm::dvec2 dudv, glm::ivec2 size)
{
    return dudv.x * size.x * dudv.y * size.y;
}

glm::dvec4 filter_bilinear(TextureData const& texture, int level, glm::dvec2 uv)
{
    return bilinear(texture, level, uv).value;
}

glm::dvec4 filter_nearest(TextureData const& texture, int level, glm::dvec2 uv)
{
    glm::dvec2 const st = glm::floor(uv * glm::dvec2(level_size(texture, level)));
    return texel(texture, level, static_cast<int>(st.x), static_cast<int>(st.y));
}

double natural(double s)
{
    return std::log(s);
}

double binary(double s)
{
    return std::log2(s);
}

double decimal(double s)
{
    return std::log10(s);
}

/// What of T is used, where T lies between the levels.
enum class Between { interpolate, exchange, finer, coarser, nearer };

struct Rule {
    Footprint footprint = larger_side;
    double (*logarithm)(double) = binary;
    Filter filter = filter_bilinear;
    Between between = Between::interpolate;
};

int last_level(TextureData const& texture)
{
    return static_cast<int>(texture.levels.size()) - 1;
}

double weight_of_coarser(double fraction, Between between)
{
    switch (between) {
        case Between::exchange:
            return 1 - fraction;
        case Between::finer:
            return 0;
        case Between::coarser:
            return fraction > 0 ? 1 : 0;
        case Between::nearer:
            return std::floor(fraction + 0.5);
        default:
            return fraction;
    }
}

/// Levels clamped at both ends, as they should be; the mistake is elsewhere.
glm::dvec4 within_levels(TextureData const& texture, glm::dvec2 uv, double t, Rule const& rule)
{
    int const last = last_level(texture);
    if (!(t > 0))
        return rule.filter(texture, 0, uv);
    if (t >= last)
        return rule.filter(texture, last, uv);
    int const finer = static_cast<int>(t);
    return glm::mix(rule.filter(texture, finer, uv), rule.filter(texture, finer + 1, uv),
                    weight_of_coarser(t - finer, rule.between));
}

Model model(Rule const& rule)
{
    return lookup_model([=](TextureData const& texture, LookupQuestion const&, glm::dvec2 uv, glm::dvec2 dudv) {
        double const s = rule.footprint(dudv, level_size(texture, 0));
        return Value(within_levels(texture, uv, rule.logarithm(s), rule));
    });
}

/// What comes out for a T outside of 0 ... last.
using Outside = Value (*)(TextureData const&, glm::dvec2 uv, double t);

Value no_such_level(TextureData const&, glm::dvec2, double)
{
    return std::nullopt;
}

Value two_levels(TextureData const& texture, glm::dvec2 uv, int finer, double weight)
{
    if (finer < 0 || finer >= last_level(texture))
        return std::nullopt;
    return glm::mix(filter_bilinear(texture, finer, uv), filter_bilinear(texture, finer + 1, uv), weight);
}

/// (int)T is level 0 down to T = -1, with a negative weight.
Value cast_below(TextureData const& texture, glm::dvec2 uv, double t)
{
    return t > -1 ? two_levels(texture, uv, 0, t) : std::nullopt;
}

Value fraction_below(TextureData const& texture, glm::dvec2 uv, double t)
{
    return two_levels(texture, uv, 0, t - std::floor(t));
}

Value extrapolated_below(TextureData const& texture, glm::dvec2 uv, double t)
{
    return two_levels(texture, uv, 0, t);
}

Value extrapolated_above(TextureData const& texture, glm::dvec2 uv, double t)
{
    int const finer = last_level(texture) - 1;
    if (finer < 0)
        return filter_bilinear(texture, 0, uv);
    return two_levels(texture, uv, finer, t - finer);
}

/// Right for T from 0 up to the last level, or but for that one; outside, the level is not clamped.
Model not_clamped(Outside below, Outside above, bool last_is_right = true)
{
    return lookup_model([=](TextureData const& texture, LookupQuestion const&, glm::dvec2 uv, glm::dvec2 dudv) {
        double const t = std::log2(larger_side(dudv, level_size(texture, 0)));
        if (below != nullptr && t < 0)
            return below(texture, uv, t);
        int const last = last_level(texture);
        if (above != nullptr && (t > last || (t == last && !last_is_right)))
            return above(texture, uv, t);
        return Value(within_levels(texture, uv, t, {}));
    });
}

/// The same from below, but for dudv = 0, which is looked after.
Model not_clamped_but_without_footprint(Outside below)
{
    return lookup_model([=](TextureData const& texture, LookupQuestion const&, glm::dvec2 uv, glm::dvec2 dudv) {
        double const t = std::log2(larger_side(dudv, level_size(texture, 0)));
        return std::isfinite(t) && t < 0 ? below(texture, uv, t) : Value(within_levels(texture, uv, t, {}));
    });
}

/// As it is, but that S = 2^last asks for the level behind the last one, too.
Model reads_behind_the_last(Outside above)
{
    return lookup_model([=](TextureData const& texture, LookupQuestion const&, glm::dvec2 uv, glm::dvec2 dudv) {
        double const t = std::log2(larger_side(dudv, level_size(texture, 0)));
        if (t == last_level(texture))
            return Value();
        if (above != nullptr && t > last_level(texture))
            return above(texture, uv, t);
        return Value(within_levels(texture, uv, t, {}));
    });
}

/// The finer of the two levels is not clamped, the coarser one is: right up to one level behind the last.
Model clamps_only_the_coarser(Outside below)
{
    return lookup_model([=](TextureData const& texture, LookupQuestion const&, glm::dvec2 uv, glm::dvec2 dudv) {
        double const t = std::log2(larger_side(dudv, level_size(texture, 0)));
        if (below != nullptr && t < 0)
            return below(texture, uv, t);
        return t >= last_level(texture) + 1 ? Value() : Value(within_levels(texture, uv, t, {}));
    });
}

/// log2(0) is minus infinity; nothing else goes wrong.
Model undefined_without_footprint()
{
    return lookup_model([](TextureData const& texture, LookupQuestion const&, glm::dvec2 uv, glm::dvec2 dudv) {
        double const s = larger_side(dudv, level_size(texture, 0));
        return s == 0 ? Value() : Value(within_levels(texture, uv, std::log2(s), {}));
    });
}

}  // namespace

void add_evaluate_trilinear_mistakes(std::vector<Mistake>& mistakes)
{
    auto const add = [&](char const* id, std::vector<Model> const& models) {
        mistakes.push_back({id, Function::evaluate_trilinear, models});
    };
    std::vector<Model> not_clamped_below;
    for (Outside const below : {no_such_level, cast_below, fraction_below, extrapolated_below}) {
        not_clamped_below.push_back(not_clamped(below, nullptr));
        not_clamped_below.push_back(not_clamped_but_without_footprint(below));
    }
    add("trilinear_not_clamped_below", not_clamped_below);
    add("trilinear_not_clamped_above", {not_clamped(nullptr, no_such_level), reads_behind_the_last(no_such_level),
                                        not_clamped(nullptr, extrapolated_above), clamps_only_the_coarser(nullptr)});
    add("trilinear_not_clamped",
        {not_clamped(no_such_level, no_such_level), not_clamped(cast_below, no_such_level),
         not_clamped(no_such_level, no_such_level, false), not_clamped(cast_below, no_such_level, false),
         clamps_only_the_coarser(no_such_level), clamps_only_the_coarser(cast_below)});
    add("trilinear_crashes_at_last_level", {reads_behind_the_last(nullptr)});
    add("trilinear_nan_without_footprint", {undefined_without_footprint()});
    add("trilinear_footprint_in_uv", {model({in_uv})});
    add("trilinear_of_nearest", {model({larger_side, binary, filter_nearest})});
    add("trilinear_does_not_interpolate", {model({larger_side, binary, filter_bilinear, Between::finer}),
                                           model({larger_side, binary, filter_bilinear, Between::coarser}),
                                           model({larger_side, binary, filter_bilinear, Between::nearer})});
    add("trilinear_exchanges_levels", {model({larger_side, binary, filter_bilinear, Between::exchange})});
    add("trilinear_smaller_side_decides", {model({smaller_side})});
    add("trilinear_uses_width_only",
        {model({width_only}), model({height_only}), model({by_width}), model({by_height})});
    add("trilinear_adds_the_sides", {model({sum_of_sides}), model({mean_of_sides}), model({diagonal}), model({area})});
    add("trilinear_natural_logarithm", {model({larger_side, natural}), model({larger_side, decimal})});
}
}  // namespace testat
