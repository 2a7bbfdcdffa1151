#include "checks/lookup.h"
#include "checks/relations.h"
#include "checks/vectors.h"

#include <fmt/format.h>

namespace testat {
namespace {
constexpr int questions_each = 256;

/// Fractions of a texel: rounding down and rounding to nearest agree on the first, not on the second.
struct Fractions {
    double lo, hi;
};
constexpr Fractions lower_half{0.1, 0.4};
constexpr Fractions upper_half{0.6, 0.9};

LookupQuestion ask_texel(Random& random, TestTexture texture, int level, glm::ivec2 size, glm::ivec2 at, Fractions f)
{
    LookupQuestion q{static_cast<std::uint32_t>(texture), level, {}, {}};
    store_uv({inside_texel(random, at.x, f.lo, f.hi), inside_texel(random, at.y, f.lo, f.hi)}, size, q.uv);
    return q;
}

Group ask_inside(Random& random, Textures const& textures, TestTexture texture, int first_level, int last_level,
                 Fractions f)
{
    std::vector<LookupQuestion> questions;
    for (int i = 0; i < questions_each; ++i) {
        int const level = random.integer(first_level, last_level);
        glm::ivec2 const size = level_size(at(textures, texture), level);
        glm::ivec2 const place(random.integer(0, size.x - 1), random.integer(0, size.y - 1));
        questions.push_back(ask_texel(random, texture, level, size, place, f));
    }
    return make_group(Kind::lookup, questions);
}

/// Both coordinates below zero, or one of them and the other inside.
glm::ivec2 negative_place(Random& random, glm::ivec2 size, int periods)
{
    glm::ivec2 place(random.integer(-periods * size.x, -1), random.integer(-periods * size.y, -1));
    if (random.integer(0, 2) == 0) {
        int const axis = random.integer(0, 1);
        place[axis] = random.integer(0, size[axis] - 1);
    }
    return place;
}

/// Anywhere inside, and in the corners of the unit square, where the texel before and the one behind are both right.
Group ask_wide(Random& random, Textures const& textures)
{
    Group const inside = ask_inside(random, textures, TestTexture::coded_wide, 0, 0, lower_half);
    std::vector<LookupQuestion> questions;
    for (std::uint32_t i = 0; i < inside.count; ++i)
        questions.push_back(question<LookupQuestion>(inside, i));
    for (int corner = 0; corner < 4; ++corner)
        questions.push_back(
            {static_cast<std::uint32_t>(TestTexture::coded_wide), 0, {float(corner % 2), float(corner / 2)}, {}});
    return make_group(Kind::lookup, questions);
}

Group ask_negative(Random& random, Textures const& textures)
{
    constexpr TestTexture modes[] = {TestTexture::coded_wide, TestTexture::coded_wide_clamp, TestTexture::coded_wide,
                                     TestTexture::coded_wide_zero};
    std::vector<LookupQuestion> questions;
    for (std::size_t i = 0; i < questions_each; ++i) {
        TestTexture const texture = modes[i % std::size(modes)];
        glm::ivec2 const size = level_size(at(textures, texture), 0);
        // Up to three periods away at first, up to |u| = 1e4 towards the end.
        int const periods = i < questions_each * 3 / 4 ? 3 : 10'000;
        glm::ivec2 const place = negative_place(random, size, periods);
        questions.push_back(ask_texel(random, texture, 0, size, place, lower_half));
    }
    return make_group(Kind::lookup, questions);
}

/// "texel (3, 5), level 0" for colours that code one.
std::string name_texel(std::array<float, 4> const& colour)
{
    bool const coded = colour[3] == 1.f && colour[0] >= 0 && colour[1] >= 0 && colour[2] >= 0;
    return coded ? fmt::format("texel ({:g}, {:g}), level {:g}", colour[1], colour[2], colour[0])
                 : format_vector({colour.begin(), colour.end()});
}

/// Any texel that a coordinate within the float error can lie in.
Deviation judge_texel(Answers const& answers, std::uint32_t index, LookupQuestion const& q, TextureData const& texture)
{
    glm::ivec2 const size = level_size(texture, q.level);
    double const s = double(q.uv[0]) * size.x;
    double const t = double(q.uv[1]) * size.y;
    double const ds = coordinate_error(q.uv[0], size.x);
    double const dt = coordinate_error(q.uv[1], size.y);
    auto const measured = floats<4>(answers, index);
    Deviation deviation{HUGE_VAL, name_texel(measured), ""};
    for (int y = int(std::floor(t - dt)); y <= int(std::floor(t + dt)); ++y)
        for (int x = int(std::floor(s - ds)); x <= int(std::floor(s + ds)); ++x) {
            glm::dvec4 const right = texel(texture, q.level, x, y);
            if (right == dvec4(measured.data()))
                deviation.in_bounds = 0;
            deviation.expected = name_texel({float(right.x), float(right.y), float(right.z), float(right.w)});
        }
    return deviation;
}

Verdict judge(Answers const& answers, Textures const& textures)
{
    return judge_each<LookupQuestion>(answers, [&](LookupQuestion const& q, std::uint32_t i) {
        return judge_texel(answers, i, q, textures[q.texture]);
    });
}

/// A texel, and its mirror image in the mirrored mean: whatever the lower fractions are, the same texel is meant.
MeanOfTextures mirror_texel(Random& random, Textures const& textures)
{
    glm::ivec2 const size = level_size(at(textures, TestTexture::unknown), 0);
    glm::ivec2 const place(random.integer(0, size.x - 1), random.integer(0, size.y - 1));
    auto const ask = [&](TestTexture texture, glm::ivec2 texel) {
        return ask_texel(random, texture, 0, size, texel, lower_half);
    };
    return {{ask(TestTexture::noise_square, place), ask(TestTexture::unknown, place),
             ask(TestTexture::unknown_mean_mirrored, size - 1 - place)},
            0};
}

auto inside(TestTexture texture, int first_level, int last_level, Fractions f)
{
    return [=](Random& random, Textures const& textures) {
        return ask_inside(random, textures, texture, first_level, last_level, f);
    };
}
}  // namespace

void add_evaluate_nearest_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto ask) {
        checks.push_back({std::string("EvaluateNearest.") + name, Function::evaluate_nearest, ask, judge});
    };
    add("SquareLevelZero", inside(TestTexture::coded_square, 0, 0, lower_half));
    add("NonSquareLevelZero", ask_wide);
    add("HigherLevels", inside(TestTexture::coded_wide, 1, 5, lower_half));
    add("UpperFractions", inside(TestTexture::coded_square, 0, 0, upper_half));
    add("NegativeCoordinates", ask_negative);
    checks.push_back(metamorphic_check("EvaluateNearest.MirroredTexture", Function::evaluate_nearest, Kind::lookup,
                                       mirror_texel, compare_mean));
}
}  // namespace testat
