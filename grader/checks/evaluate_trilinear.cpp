#include "checks/lookup.h"
#include "checks/oracles.h"
#include "checks/relations.h"
#include "checks/vectors.h"

#include <algorithm>

namespace testat {
namespace {
constexpr std::size_t questions_each = 256;

/// Where uv lie: in the unit square, or up to one period outside.
enum class Place { inside, anywhere };

/// A footprint in texels of level 0.
LookupQuestion ask_footprint(Random& random, Textures const& textures, TestTexture texture, Place place,
                             glm::dvec2 footprint)
{
    double const outside = place == Place::anywhere ? 1 : 0;
    LookupQuestion q{static_cast<std::uint32_t>(texture), 0, {}, {}};
    store(glm::dvec2(random.uniform(-outside, 1 + outside), random.uniform(-outside, 1 + outside)), q.uv);
    store(footprint / glm::dvec2(level_size(at(textures, texture), 0)), q.dudv);
    return q;
}

/// The textures take turns, so that what is remembered of one is wrong for the other. `footprint` is asked for a side
/// in texels, or both, of question i on a texture with this last level.
template <typename Footprint>
auto ask(std::vector<TestTexture> const& which, Footprint const& footprint, Place place = Place::inside)
{
    return [=](Random& random, Textures const& textures) {
        std::vector<LookupQuestion> questions;
        for (std::size_t i = 0; i < questions_each; ++i) {
            TestTexture const texture = which[i % which.size()];
            double const last = double(at(textures, texture).levels.size()) - 1;
            questions.push_back(
                ask_footprint(random, textures, texture, place, glm::dvec2(footprint(random, int(i), last))));
        }
        return make_group(Kind::lookup, questions);
    };
}

/// T clearly above the first level up to the last but one, and a few whole numbers. Where the levels begin and end is
/// for others to ask. The lowest T is always asked, so that chance decides nothing for who begins too late.
double between_levels(Random& random, int i, double last)
{
    constexpr double lowest = 0.3;
    if (i % 8 == 0)
        return std::exp2(random.integer(1, 4));
    return std::exp2(i == 1 ? lowest : random.uniform(lowest, last - 1.05));
}

/// The larger side decides, whichever it is; the other may be anything, zero included.
glm::dvec2 unequal(Random& random, int i, double last)
{
    double const larger = std::exp2(random.uniform(0.5, last - 1.1));
    double const smaller = i % 8 == 0 ? 0 : larger * random.uniform(0.05, 0.6);
    return random.coin() ? glm::dvec2(larger, smaller) : glm::dvec2(smaller, larger);
}

/// At most one texel; now and then exactly one, or a little more.
double magnified(Random& random, int i)
{
    constexpr double just_above[] = {1.003, 1.01, 1.04, 1.1};
    if (i % 16 == 8)
        return just_above[i / 16 % int(std::size(just_above))];
    return i % 16 == 0 ? 1 : std::exp2(random.uniform(-12, 0));
}

/// The first four exactly in the corners of the unit square.
Group ask_magnified(Random& random, Textures const& textures)
{
    std::vector<LookupQuestion> questions;
    for (int i = 0; i < int(questions_each); ++i) {
        LookupQuestion q =
            ask_footprint(random, textures, TestTexture::noise_square, Place::inside, glm::dvec2(magnified(random, i)));
        if (i < 4)
            store(glm::dvec2(i % 2, i / 2), q.uv);
        questions.push_back(q);
    }
    return make_group(Kind::lookup, questions);
}

/// Exactly the last level, which may be the only one, and up to there from where BetweenLevels ends.
double last_level(Random& random, int i, double last)
{
    return std::exp2(i / 2 % 2 == 0 || last == 0 ? last : random.uniform(4.05, last - 0.05));
}

double beyond(Random& random, int, double last)
{
    return std::exp2(last + random.uniform(0.05, 10));
}

/// A lookup between levels, and its mirror image in the mirrored mean without level 0: there each level is one lower,
/// and so is T, which is far from whole numbers, where mistakes begin. In multiples of 2^-16, uv is exact when
/// mirrored.
MeanOfTextures mirror_without_level_zero(Random& random, Textures const& textures)
{
    glm::dvec2 const uv(random.integer(1, 0xffff) * 0x1p-16, random.integer(1, 0xffff) * 0x1p-16);
    glm::dvec2 const footprint(std::exp2(random.integer(1, 4) + random.uniform(0.3, 0.7)));
    glm::dvec2 const dudv = footprint / glm::dvec2(level_size(at(textures, TestTexture::unknown), 0));
    MeanOfTextures relation{};
    constexpr TestTexture which[] = {TestTexture::noise_square, TestTexture::unknown,
                                     TestTexture::unknown_mean_coarser};
    for (std::size_t i = 0; i < 3; ++i) {
        LookupQuestion& q = relation.questions[i];
        q.texture = static_cast<std::uint32_t>(which[i]);
        store(i == 2 ? 1.0 - uv : uv, q.uv);
        store(dudv, q.dudv);
        glm::dvec4 const b = trilinear(textures[q.texture], dvec2(q.uv), dvec2(q.dudv)).bound;
        relation.bound += (i == 2 ? 1 : 0.5) * std::max({b.r, b.g, b.b, b.a});
    }
    return relation;
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
    auto const nothing = [](Random&, int, double) { return 0.0; };
    add("BetweenLevels", ask({TestTexture::noise_square}, between_levels));
    add("LargerSideDecides", ask({TestTexture::noise_wide, TestTexture::noise_high, TestTexture::noise_square,
                                  TestTexture::stripes_clamp, TestTexture::stripes_zero},
                                 unequal, Place::anywhere));
    add("Magnified", ask_magnified);
    add("NoFootprint", ask({TestTexture::noise_square}, nothing));
    add("LastLevel", ask({TestTexture::noise_square, TestTexture::noise_long, TestTexture::mip_single}, last_level));
    add("BeyondTheLastLevel",
        ask({TestTexture::noise_square, TestTexture::mip_single, TestTexture::noise_long, TestTexture::stripes_zero},
            beyond));
    checks.push_back(metamorphic_check("EvaluateTrilinear.MirroredTexture", Function::evaluate_trilinear, Kind::lookup,
                                       mirror_without_level_zero, compare_mean));
}
}  // namespace testat
