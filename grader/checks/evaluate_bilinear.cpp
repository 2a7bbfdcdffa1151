#include "checks/lookup.h"
#include "checks/oracles.h"
#include "checks/vectors.h"

#include <fmt/format.h>

namespace testat {
namespace {
constexpr int questions_each = 256;

LookupQuestion ask_at(TestTexture texture, Textures const& textures, int level, glm::dvec2 st)
{
    LookupQuestion q{static_cast<std::uint32_t>(texture), level, {}, {}};
    store_uv(st, level_size(at(textures, texture), level), q.uv);
    return q;
}

Group ask_constant(Random& random, Textures const& textures)
{
    std::vector<LookupQuestion> questions;
    for (int i = 0; i < questions_each; ++i)
        questions.push_back(
            ask_at(TestTexture::constant, textures, 0, {random.uniform(0.5, 7.5), random.uniform(0.5, 7.5)}));
    return make_group(Kind::lookup, questions);
}

Group ask_centres(Random& random, Textures const& textures)
{
    std::vector<LookupQuestion> questions{ask_at(TestTexture::noise_square, textures, 0, {1.5, 1.5})};
    for (int i = 1; i < questions_each; ++i)
        questions.push_back(
            ask_at(TestTexture::noise_square, textures, 0, {random.integer(1, 30) + 0.5, random.integer(1, 30) + 0.5}));
    return make_group(Kind::lookup, questions);
}

/// Between inner texels, on levels of a non-square texture.
Group ask_fractions(Random& random, Textures const& textures)
{
    std::vector<LookupQuestion> questions;
    for (int i = 0; i < questions_each; ++i) {
        int const level = random.integer(0, 2);
        glm::ivec2 const size = level_size(at(textures, TestTexture::noise_wide), level);
        questions.push_back(ask_at(TestTexture::noise_wide, textures, level,
                                   {random.uniform(1, size.x - 1.5), random.uniform(1, size.y - 1.5)}));
    }
    return make_group(Kind::lookup, questions);
}

/// Two points in the half texel behind the centres of texel (x, y). There the four neighbours are the same whether or
/// not the half-texel shift is there, and so is the difference of the two values along s and along t.
void add_pair(Random& random, Textures const& textures, glm::ivec2 texel, bool from_centre,
              std::vector<LookupQuestion>& questions)
{
    auto const point = [&](double lo, double hi) {
        return glm::dvec2(inside_texel(random, texel.x, lo, hi), inside_texel(random, texel.y, lo, hi));
    };
    glm::dvec2 const first = from_centre ? glm::dvec2(texel) + 0.5 : point(0.55, 0.7);
    questions.push_back(ask_at(TestTexture::stripes, textures, 0, first));
    questions.push_back(ask_at(TestTexture::stripes, textures, 0, point(0.8, 0.95)));
}

auto ask_pairs(glm::ivec2 first, glm::ivec2 last, bool with_centres)
{
    return [=](Random& random, Textures const& textures) {
        std::vector<LookupQuestion> questions;
        for (int i = 0; i < questions_each / 2; ++i) {
            glm::ivec2 const texel(random.integer(first.x, last.x), random.integer(first.y, last.y));
            add_pair(random, textures, texel, with_centres && i % 2 == 0, questions);
        }
        return make_group(Kind::lookup, questions);
    };
}

Deviation compare_difference(Answers const& answers, std::uint32_t index, Lookup const& a, Lookup const& b)
{
    auto const before = floats<4>(answers, index - 1);
    auto const after = floats<4>(answers, index);
    std::vector<double> measured, expected, bound;
    for (int c = 0; c < 4; ++c) {
        measured.push_back(double(after[std::size_t(c)]) - before[std::size_t(c)]);
        expected.push_back(b.value[c] - a.value[c]);
        bound.push_back(a.bound[c] + b.bound[c]);
    }
    Deviation deviation = compare(measured, expected, bound);
    auto const from = question<LookupQuestion>(answers.group, index - 1);
    deviation.measured =
        fmt::format("f(uv) - f(uv0) = {}, uv0 = {}", deviation.measured, format_vector({from.uv[0], from.uv[1]}));
    return deviation;
}

Verdict judge_differences(Answers const& answers, Textures const& textures)
{
    return judge_each<LookupQuestion>(answers, [&](LookupQuestion const& q, std::uint32_t i) {
        if (i % 2 == 0)
            return Deviation{};
        auto const before = question<LookupQuestion>(answers.group, i - 1);
        return compare_difference(answers, i, bilinear(textures[q.texture], q.level, dvec2(before.uv)),
                                  bilinear(textures[q.texture], q.level, dvec2(q.uv)));
    });
}
}  // namespace

Deviation bilinear_deviation(Answers const& answers, std::uint32_t index, Textures const& textures, Words words)
{
    auto const q = question<LookupQuestion>(answers.group, index);
    return compare_lookup(answers, index, bilinear(textures[q.texture], q.level, dvec2(q.uv)), words);
}

void add_evaluate_bilinear_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto ask, auto judge) {
        checks.push_back({std::string("EvaluateBilinear.") + name, Function::evaluate_bilinear, ask, judge});
    };
    add("ConstantTexture", ask_constant, judge_by(bilinear_deviation));
    add("TexelCentres", ask_centres, judge_by(bilinear_deviation));
    add("Fractions", ask_fractions, judge_by(bilinear_deviation));
    add("Gradients", ask_pairs({1, 1}, {13, 13}, false), judge_differences);
    add("GradientsAtTheBorder", ask_pairs({15, 15}, {15, 15}, false), judge_differences);
    add("NegativeCoordinates", ask_pairs({-48, -48}, {-2, -2}, true), judge_differences);
}
}  // namespace testat
