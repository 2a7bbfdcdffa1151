#include "checks/lookup.h"
#include "checks/oracles.h"
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
/// Beside a border, but farther than a coordinate may be off by in these textures.
constexpr double beside = 0x1p-14;
constexpr Fractions first_of_texel{beside, 2 * beside};
constexpr Fractions last_of_texel{1 - 2 * beside, 1 - beside};

LookupQuestion ask_texel(Random& random, TestTexture texture, int level, glm::ivec2 size, glm::ivec2 at, Fractions f)
{
    LookupQuestion q{static_cast<std::uint32_t>(texture), level, {}, {}};
    store_uv({inside_texel(random, at.x, f.lo, f.hi), inside_texel(random, at.y, f.lo, f.hi)}, size, q.uv);
    return q;
}

Group ask_inside(Random& random, Textures const& textures, TestTexture texture, int first_level, int last_level,
                 Fractions f, Fractions now_and_then)
{
    std::vector<LookupQuestion> questions;
    for (int i = 0; i < questions_each; ++i) {
        int const level = random.integer(first_level, last_level);
        glm::ivec2 const size = level_size(at(textures, texture), level);
        glm::ivec2 const place(random.integer(0, size.x - 1), random.integer(0, size.y - 1));
        questions.push_back(ask_texel(random, texture, level, size, place, i % 8 == 7 ? now_and_then : f));
    }
    return make_group(Kind::lookup, questions);
}

/// Both coordinates below zero, or beyond the other end, or one of them and the other inside.
glm::ivec2 outer_place(Random& random, glm::ivec2 size, int periods)
{
    glm::ivec2 place(random.integer(-periods * size.x, -1), random.integer(-periods * size.y, -1));
    if (random.integer(0, 3) == 0)
        place = size - 1 - place;
    if (random.integer(0, 2) == 0) {
        int const axis = random.integer(0, 1);
        place[axis] = random.integer(0, size[axis] - 1);
    }
    return place;
}

/// Now and then on coarser levels, also those whose shorter side is 1 for more than one level.
Group ask_outside(Random& random, Textures const& textures)
{
    constexpr TestTexture modes[] = {TestTexture::coded_wide, TestTexture::coded_wide_clamp, TestTexture::coded_wide,
                                     TestTexture::coded_wide_zero};
    std::vector<LookupQuestion> questions;
    for (std::size_t i = 0; i < questions_each; ++i) {
        TestTexture const texture = modes[i % std::size(modes)];
        int const level = i % 16 >= 12 ? random.integer(1, 5) : 0;
        glm::ivec2 const size = level_size(at(textures, texture), level);
        // Up to three periods away at first, up to |u| = 1e4 towards the end.
        int const periods = i < questions_each * 3 / 4 ? 3 : 10'000;
        glm::ivec2 const place = outer_place(random, size, periods);
        questions.push_back(ask_texel(random, texture, level, size, place, lower_half));
    }
    // And the corners of the unit square, where the texel before and the one behind are both right.
    for (float const u : {0.f, 1.f})
        for (float const v : {0.f, 1.f})
            questions.push_back({static_cast<std::uint32_t>(TestTexture::coded_wide), 0, {u, v}, {}});
    return make_group(Kind::lookup, questions);
}

/// "texel (3, 5), level 0" for colours that code one.
std::string name_texel(std::array<float, 4> const& colour)
{
    bool const coded = colour[3] == 1.f && colour[0] >= 0 && colour[1] >= 0 && colour[2] >= 0;
    return coded ? fmt::format("texel ({:g}, {:g}), level {:g}", colour[1], colour[2], colour[0])
                 : format_vector({colour.begin(), colour.end()});
}

/// How far a coordinate lies outside of a texel's interval, in units of its error.
double distance_to(int texel, double coordinate, double error)
{
    return std::max({0.0, texel - coordinate, coordinate - (texel + 1.0)}) / error;
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

auto inside(TestTexture texture, int first_level, int last_level, Fractions f, Fractions now_and_then)
{
    return [=](Random& random, Textures const& textures) {
        return ask_inside(random, textures, texture, first_level, last_level, f, now_and_then);
    };
}
}  // namespace

/// Any texel that a coordinate within the float error can lie in is right.
Deviation nearest_deviation(Answers const& answers, std::uint32_t index, Textures const& textures, Words words)
{
    auto const q = question<LookupQuestion>(answers.group, index);
    TextureData const& texture = textures[q.texture];
    glm::dvec2 const size = level_size(texture, q.level);
    glm::dvec2 const st = dvec2(q.uv) * size;
    glm::dvec2 const error(coordinate_error(q.uv[0], int(size.x)), coordinate_error(q.uv[1], int(size.y)));
    glm::ivec2 const first = glm::floor(st - error);
    glm::ivec2 const last = glm::floor(st + error);
    auto const measured = floats<4>(answers, index);
    Deviation deviation;
    deviation.in_bounds = HUGE_VAL;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
            if (texel(texture, q.level, x, y) == dvec4(measured.data()))
                deviation.in_bounds = std::min(deviation.in_bounds,
                                               std::max(distance_to(x, st.x, error.x), distance_to(y, st.y, error.y)));
    if (words == Words::always || deviation.in_bounds > 1) {
        deviation.measured = name_texel(measured);
        glm::vec4 const right(texel(texture, q.level, last.x, last.y));
        deviation.expected = name_texel({right.r, right.g, right.b, right.a});
    }
    return deviation;
}

void add_evaluate_nearest_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto ask) {
        checks.push_back(
            {std::string("EvaluateNearest.") + name, Function::evaluate_nearest, ask, judge_by(nearest_deviation)});
    };
    add("SquareLevelZero", inside(TestTexture::coded_square, 0, 0, lower_half, lower_half));
    add("NonSquareLevelZero", inside(TestTexture::coded_wide, 0, 0, lower_half, first_of_texel));
    add("HigherLevels", inside(TestTexture::coded_wide, 1, 5, lower_half, lower_half));
    add("UpperFractions", inside(TestTexture::coded_square, 0, 0, upper_half, last_of_texel));
    add("NegativeCoordinates", ask_outside);
    checks.push_back(metamorphic_check("EvaluateNearest.MirroredTexture", Function::evaluate_nearest, Kind::lookup,
                                       mirror_texel, compare_mean));
}
}  // namespace testat
