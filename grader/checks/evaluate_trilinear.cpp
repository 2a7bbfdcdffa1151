#include "checks/lookup.h"
#include "checks/oracles.h"
#include "checks/vectors.h"

namespace testat {
namespace {
constexpr std::size_t questions_each = 256;

/// uv anywhere in the unit square, with a footprint in texels of level 0.
LookupQuestion ask_footprint(Random& random, Textures const& textures, TestTexture texture, glm::dvec2 footprint)
{
    LookupQuestion q{static_cast<std::uint32_t>(texture), 0, {}, {}};
    store(glm::dvec2(random.uniform(0, 1), random.uniform(0, 1)), q.uv);
    store(footprint / glm::dvec2(level_size(at(textures, texture), 0)), q.dudv);
    return q;
}

/// The textures take turns, so that what is remembered of one is wrong for the other.
template <typename Footprint>
auto ask(std::vector<TestTexture> const& which, Footprint const& footprint)
{
    return [=](Random& random, Textures const& textures) {
        std::vector<LookupQuestion> questions;
        for (std::size_t i = 0; i < questions_each; ++i)
            questions.push_back(ask_footprint(random, textures, which[i % which.size()], footprint(random, int(i))));
        return make_group(Kind::lookup, questions);
    };
}

/// T between the first level and the last, and a few whole numbers.
glm::dvec2 between_levels(Random& random, int i)
{
    double const t = i % 8 == 0 ? random.integer(1, 4) : random.uniform(0.05, 4.95);
    return glm::dvec2(std::exp2(t));
}

/// The larger side decides, whichever it is; the other may be anything, zero included.
glm::dvec2 unequal(Random& random, int i)
{
    double const larger = std::exp2(random.uniform(0.5, 4.9));
    double const smaller = i % 8 == 0 ? 0 : larger * random.uniform(0.05, 0.6);
    return random.coin() ? glm::dvec2(larger, smaller) : glm::dvec2(smaller, larger);
}

glm::dvec2 magnified(Random& random, int i)
{
    return glm::dvec2(i % 8 == 0 ? 1 : std::exp2(random.uniform(-12, 0)));
}

glm::dvec2 beyond(Random& random, int)
{
    return glm::dvec2(32 * std::exp2(random.uniform(0.05, 10)));
}
}  // namespace

Deviation trilinear_deviation(Answers const& answers, std::uint32_t index, Textures const& textures, Words words)
{
    auto const q = question<LookupQuestion>(answers.group, index);
    return compare_lookup(answers, index, trilinear(textures[q.texture], dvec2(q.uv), dvec2(q.dudv)), words);
}

void add_evaluate_trilinear_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto asked) {
        checks.push_back({std::string("EvaluateTrilinear.") + name, Function::evaluate_trilinear, asked,
                          judge_by(trilinear_deviation)});
    };
    auto const constant = [](double texels) { return [=](Random&, int) { return glm::dvec2(texels); }; };
    add("BetweenLevels", ask({TestTexture::noise_square}, between_levels));
    add("LargerSideDecides", ask({TestTexture::noise_wide, TestTexture::noise_square}, unequal));
    add("Magnified", ask({TestTexture::noise_square}, magnified));
    add("NoFootprint", ask({TestTexture::noise_square}, constant(0)));
    add("LastLevel", ask({TestTexture::noise_square}, constant(32)));
    add("BeyondTheLastLevel", ask({TestTexture::noise_square}, beyond));
}
}  // namespace testat
