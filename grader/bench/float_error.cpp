#include "bench/float_error.h"

#include "checks/random.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace testat::bench {
namespace {
constexpr std::uint32_t questions_each = 4096;

/// Multiples of 2^-12 in [0, 1).
TextureData noisy(Random& random, int side)
{
    return with_levels(side, side, Wrap::repeat, [&random](int, int, int) {
        glm::vec4 c;
        for (int i = 0; i < 4; ++i)
            c[i] = static_cast<float>(random.integer(0, 4095)) / 4096.f;
        return c;
    });
}

int side_for(double farthest)
{
    int side = 256;
    while (side * farthest >= 0x1p23)
        side /= 2;
    return side;
}

/// The farthest tenth of a decade as often as all the rest.
float coordinate(Random& random, double farthest)
{
    double const u = random.uniform(random.coin() ? 0.9 : 0, 1) * farthest;
    return static_cast<float>(random.coin() ? u : -u);
}

Oracle oracle_of(Function function)
{
    return function == Function::evaluate_bilinear ? bilinear_deviation : trilinear_deviation;
}
}  // namespace

FarLookups far_lookups(Function function, int decade)
{
    double const farthest = std::pow(10.0, decade);
    Random random(static_cast<std::uint64_t>(decade), "bench/far lookups");
    int const side = side_for(farthest);
    FarLookups far{{noisy(random, side)}, {}};
    std::vector<LookupQuestion> questions;
    for (std::uint32_t i = 0; i < questions_each; ++i) {
        LookupQuestion q{0, 0, {coordinate(random, farthest), coordinate(random, farthest)}, {}};
        for (float& extent : q.dudv)
            extent = static_cast<float>(std::exp2(random.uniform(-1, std::log2(side) + 1)) / side);
        questions.push_back(q);
    }
    far.group = make_group(Kind::lookup, questions);
    far.group.under_test = function;
    return far;
}

double worst_error(Answers const& answers, Textures const& textures)
{
    if (answers.status.answered < answers.group.count)
        return HUGE_VAL;
    double worst = 0;
    Oracle const oracle = oracle_of(answers.group.under_test);
    for (std::uint32_t i = 0; i < answers.group.count; ++i) {
        double const error = oracle(answers, i, textures, Words::for_mistakes).in_bounds;
        worst = error < HUGE_VAL ? std::max(worst, error) : HUGE_VAL;
    }
    return worst;
}

Answers ask(LookUp const& look_up, Group const& group)
{
    Footprints footprints;
    for (std::uint32_t i = 0; i < group.count; ++i) {
        auto const q = question<LookupQuestion>(group, i);
        footprints.push_back({{q.uv[0], q.uv[1]}, {}, {}, {q.dudv[0], q.dudv[1]}});
    }
    Colours colours(footprints.size());
    look_up(footprints.data(), footprints.size(), colours.data());
    Answers answers{group, {}, std::vector<std::uint32_t>(group.answer_size())};
    answers.status.answered = group.count;
    std::memcpy(answers.words.data(), colours.data(), 4 * answers.words.size());
    return answers;
}
}  // namespace testat::bench
