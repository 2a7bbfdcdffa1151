#include "checks/mistakes/lookups.h"
#include "checks/vectors.h"

namespace testat {
namespace {
/// Which level gives the size, which one the texels, and how st becomes a texel.
struct Rule {
    double (*round)(double);
    bool size_of_level_zero = false;
    bool texels_of_level_zero = false;
    bool exchange_sides = false;
    int smaller_by = 0;  ///< what is taken from the size before uv is scaled by it
};

Model model(Rule const& rule)
{
    return lookup_model(
        [=](TextureData const& texture, LookupQuestion const& q, glm::dvec2 uv, glm::dvec2) {
            glm::ivec2 size = level_size(texture, rule.size_of_level_zero ? 0 : q.level) - rule.smaller_by;
            if (rule.exchange_sides)
                std::swap(size.x, size.y);
            return std::optional(texel(texture, rule.texels_of_level_zero ? 0 : q.level,
                                       static_cast<int>(rule.round(uv.x * size.x)),
                                       static_cast<int>(rule.round(uv.y * size.y))));
        },
        rule.smaller_by);
}

double down(double x)
{
    return std::floor(x);
}

double towards_zero(double x)
{
    return std::trunc(x);
}

double nearest(double x)
{
    return std::floor(x + 0.5);
}

double half_away_from_zero(double x)
{
    return std::round(x);
}

double one_half_and_cast(double x)
{
    return std::trunc(x + 0.5);
}
}  // namespace

void add_evaluate_nearest_mistakes(std::vector<Mistake>& mistakes)
{
    auto const add = [&](char const* id, std::vector<Rule> const& rules) {
        Mistake mistake{id, Function::evaluate_nearest, {}};
        for (auto const& rule : rules)
            mistake.models.push_back(model(rule));
        mistakes.push_back(std::move(mistake));
    };
    add("nearest_casts", {{towards_zero}});
    add("nearest_rounds", {{nearest}, {half_away_from_zero}});
    add("nearest_adds_one_half", {{one_half_and_cast}});
    add("nearest_size_of_level_zero", {{down, true}});
    add("nearest_ignores_level", {{down, false, true}, {down, true, true}});
    add("nearest_swaps_width_and_height", {{down, false, false, true}});
    add("nearest_scales_by_size_minus_one", {{down, false, false, false, 1}, {nearest, false, false, false, 1}});
}
}  // namespace testat
