#include "checks/mistakes/lookups.h"

#include "checks/vectors.h"

#include <algorithm>

namespace testat {
namespace {
/// The hull of some values, and whether anything undefined was among them.
struct Outcomes {
    glm::dvec4 lo{HUGE_VAL};
    glm::dvec4 hi{-HUGE_VAL};
    bool undefined = false;

    void add(std::optional<glm::dvec4> const& value)
    {
        if (!value || !std::isfinite(value->x + value->y + value->z + value->w)) {
            undefined = true;
            return;
        }
        lo = glm::min(lo, *value);
        hi = glm::max(hi, *value);
    }

    bool has(glm::dvec4 value) const
    {
        if (!std::isfinite(value.x + value.y + value.z + value.w))
            return undefined;
        glm::dvec4 const roundings = 32 * eps * glm::max(glm::max(glm::abs(lo), glm::abs(hi)), glm::dvec4(1));
        glm::dvec4 const margin = (hi - lo) + roundings;
        for (int c = 0; c < 4; ++c)
            if (!(value[c] >= lo[c] - margin[c] && value[c] <= hi[c] + margin[c]))
                return false;
        return true;
    }
};

/// How far off a u may seem to be after it has been scaled and shifted in float. Nothing where that is exact, as at
/// texel centres of sizes that are powers of two: there some mistakes show that a hull would hide.
double uv_error(double u, int size)
{
    double const s = u * size - 0.5;
    bool const exact = (size & (size - 1)) == 0 && double(float(s)) == s;
    return exact ? 0 : coordinate_error(u, size) / size;
}

/// The relative error of a footprint, in the same way: none where log2 of its size in texels is a whole number.
double footprint_error(glm::dvec2 dudv, glm::ivec2 size)
{
    int exponent = 0;
    double const mantissa = std::frexp(std::max(dudv.x * size.x, dudv.y * size.y), &exponent);
    return mantissa == 0.5 ? 0 : 8 * eps;
}

/// Three factors or shifts for what a rounding may do: down, nothing, up.
constexpr double directions[] = {-1, 0, 1};

Outcomes outcomes(WrongLookup const& wrong, int smaller_by, TextureData const& texture, LookupQuestion const& q,
                  Function function)
{
    bool const with_footprint = function == Function::evaluate_trilinear;
    glm::ivec2 const size = level_size(texture, with_footprint ? 0 : q.level) - smaller_by;
    glm::dvec2 const uv = dvec2(q.uv);
    glm::dvec2 const error(uv_error(uv.x, size.x), uv_error(uv.y, size.y));
    double const stretch = footprint_error(dvec2(q.dudv), size);
    Outcomes all;
    for (double const x : directions)
        for (double const y : directions)
            for (double const z : directions)
                if (with_footprint || z == 0)
                    all.add(wrong(texture, q, uv + glm::dvec2(x, y) * error, dvec2(q.dudv) * (1 + stretch * z)));
    return all;
}
}  // namespace

Model lookup_model(WrongLookup const& wrong, int smaller_by)
{
    return {[=](Answers const& answers, std::uint32_t i, Textures const& textures) {
                auto const q = question<LookupQuestion>(answers.group, i);
                return outcomes(wrong, smaller_by, textures[q.texture], q, answers.group.under_test)
                    .has(dvec4(floats<4>(answers, i).data()));
            },
            [=](Group const& group, std::uint32_t i, Textures const& textures) {
                auto const q = question<LookupQuestion>(group, i);
                return outcomes(wrong, smaller_by, textures[q.texture], q, group.under_test).undefined;
            }};
}
}  // namespace testat
