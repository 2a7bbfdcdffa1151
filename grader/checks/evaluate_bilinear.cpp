#include "checks/lookup.h"
#include "checks/oracles.h"
#include "checks/relations.h"
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
        questions.push_back(ask_at(i % 8 == 7 ? TestTexture::bright : TestTexture::noise_square, textures, 0,
                                   {random.integer(1, 30) + 0.5, random.integer(1, 30) + 0.5}));
    return make_group(Kind::lookup, questions);
}

/// In the middle of the only row or column of a texture. There, no neighbour on the other side of a border counts.
LookupQuestion ask_thin(Random& random, Textures const& textures)
{
    double const along = random.uniform(1, 14.5);
    return random.coin() ? ask_at(TestTexture::mip_row, textures, 0, {along, 0.5})
                         : ask_at(TestTexture::mip_column, textures, 0, {0.5, along});
}

/// Between inner texels, on levels of a non-square texture, some of them on textures one texel wide or high.
Group ask_fractions(Random& random, Textures const& textures)
{
    std::vector<LookupQuestion> questions;
    for (int i = 0; i < questions_each; ++i) {
        if (i % 8 == 7) {
            questions.push_back(ask_thin(random, textures));
            continue;
        }
        // A coarse level first, so that a size that is kept from the first call is not level 0's.
        int const level = i == 0 ? 2 : random.integer(0, 2);
        glm::ivec2 const size = level_size(at(textures, TestTexture::noise_wide), level);
        questions.push_back(ask_at(TestTexture::noise_wide, textures, level,
                                   {random.uniform(1, size.x - 1.5), random.uniform(1, size.y - 1.5)}));
    }
    return make_group(Kind::lookup, questions);
}

/// Two points in the half texel behind the centres of texel (x, y). There the four neighbours are the same whether or
/// not the half-texel shift is there, and so is the difference of the two values along s and along t.
void add_pair(Random& random, Textures const& textures, TestTexture texture, int level, glm::ivec2 texel,
              bool from_centre, std::vector<LookupQuestion>& questions)
{
    auto const point = [&](double lo, double hi) {
        return glm::dvec2(inside_texel(random, texel.x, lo, hi), inside_texel(random, texel.y, lo, hi));
    };
    glm::dvec2 const first = from_centre ? glm::dvec2(texel) + 0.5 : point(0.55, 0.7);
    questions.push_back(ask_at(texture, textures, level, first));
    questions.push_back(ask_at(texture, textures, level, point(0.8, 0.95)));
}

/// Both coordinates below zero, or one of them and the other inside; every other pair begins at a texel centre. Now and
/// then on level 1.
Group ask_negative(Random& random, Textures const& textures)
{
    std::vector<LookupQuestion> questions;
    for (int i = 0; i < questions_each / 2; ++i) {
        // Up to three periods away at first, up to 128 towards the end: beyond, a float has too few digits to tell.
        int const farthest = i < questions_each * 3 / 8 ? 48 : 2048;
        int const level = i % 8 == 7 ? 1 : 0;
        glm::ivec2 texel(random.integer(-farthest, -2), random.integer(-farthest, -2));
        if (random.integer(0, 2) == 0)
            texel[random.integer(0, 1)] = random.integer(1, level == 0 ? 13 : 5);
        add_pair(random, textures, TestTexture::stripes, level, texel, i % 2 == 0, questions);
    }
    return make_group(Kind::lookup, questions);
}

Group ask_inner(Random& random, Textures const& textures)
{
    std::vector<LookupQuestion> questions;
    for (int i = 0; i < questions_each / 2; ++i) {
        glm::ivec2 const texel(random.integer(1, 13), random.integer(1, 13));
        add_pair(random, textures, TestTexture::stripes, 0, texel, false, questions);
    }
    return make_group(Kind::lookup, questions);
}

/// Both coordinates a texel or more before the first centre, or behind the last: there the four neighbours wrap to one
/// and the same, the last or none, whether or not the half-texel shift is there.
LookupQuestion ask_outside(Random& random, Textures const& textures, TestTexture texture, bool behind_s, bool behind_t)
{
    auto const coordinate = [&](bool behind) {
        double const away = random.uniform(1.6, 40);
        return behind ? 16 + away : -away;
    };
    return ask_at(texture, textures, 0, {coordinate(behind_s), coordinate(behind_t)});
}

/// Differences from before one end, or both, to behind both.
void add_corners(Random& random, Textures const& textures, TestTexture texture, std::vector<LookupQuestion>& questions)
{
    for (int i = 0; i < 3; ++i) {
        questions.push_back(ask_outside(random, textures, texture, i == 1, i == 2));
        questions.push_back(ask_outside(random, textures, texture, true, true));
    }
}

/// Behind the centre of the last texel, where the wrap mode says what the neighbours are. In mode zero one column
/// further: what falls to zero from texel to texel depends on the half-texel shift, what is zero does not. Each corner
/// of the texture twice, where the difference is 0 whatever the value is, unless it is not finite. And farther outside.
Group ask_border(Random& random, Textures const& textures)
{
    std::vector<LookupQuestion> questions;
    for (double s : {0, 16})
        for (double t : {0, 16})
            questions.insert(questions.end(), 2, ask_at(TestTexture::stripes, textures, 0, {s, t}));
    for (int i = 0; i < questions_each / 8; ++i) {
        add_pair(random, textures, TestTexture::stripes, 0, {15, 15}, false, questions);
        add_pair(random, textures, TestTexture::stripes, 1, {7, 7}, false, questions);
        add_pair(random, textures, TestTexture::stripes_clamp, 0, {15, 15}, false, questions);
        add_pair(random, textures, TestTexture::stripes_zero, 0, {17, random.integer(1, 13)}, false, questions);
    }
    for (int i = 0; i < questions_each / 32; ++i)
        for (TestTexture const texture : {TestTexture::stripes_clamp, TestTexture::stripes_zero})
            add_corners(random, textures, texture, questions);
    return make_group(Kind::lookup, questions);
}

/// A place between texels, far enough from all places where mistakes jump: borders and centres. In multiples of 2^-10,
/// so that uv is exact in textures of 32 texels, and is also exact when it is moved.
double clear_of_jumps(Random& random, int texel)
{
    return texel + (random.coin() ? 512 : 0) / 1024.0 + random.integer(102, 410) / 1024.0;
}

/// Linear in the texture, and moved with it by whole texels. That holds for every fixed mix of neighbours, so for most
/// mistakes, too.
MeanOfTextures move_by_texels(Random& random, Textures const& textures)
{
    glm::ivec2 const size = level_size(at(textures, TestTexture::unknown), 0);
    glm::ivec2 const last = size - 2 - texture_shift;
    glm::dvec2 const st(clear_of_jumps(random, random.integer(1, last.x)),
                        clear_of_jumps(random, random.integer(1, last.y)));
    // Of three lookups whose texels differ by 1 at most, two of them with half the weight.
    double const bound = 2 * (coordinate_error(1, size.x) + coordinate_error(1, size.y) + 10 * eps);
    return {{ask_at(TestTexture::noise_square, textures, 0, st), ask_at(TestTexture::unknown, textures, 0, st),
             ask_at(TestTexture::unknown_mean_shifted, textures, 0, st + glm::dvec2(texture_shift))},
            bound};
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
    add("Gradients", ask_inner, judge_differences);
    add("GradientsAtTheBorder", ask_border, judge_differences);
    add("NegativeCoordinates", ask_negative, judge_differences);
    checks.push_back(metamorphic_check("EvaluateBilinear.LinearInTheTexture", Function::evaluate_bilinear, Kind::lookup,
                                       move_by_texels, compare_mean));
}
}  // namespace testat
