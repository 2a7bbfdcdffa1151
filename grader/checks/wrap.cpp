#include "checks/oracles.h"
#include "checks/relations.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat {
namespace {
constexpr int questions_each = 512;
/// Farther than the ten thousand periods that a file may add to be on the safe side, near enough for a loop or a
/// recursion that goes on by `step` again and again.
int farthest(int step)
{
    return std::min(1'000'000, 60'000 * step);
}

int repeat(int val, int size)
{
    int const remainder = val % size;
    return remainder < 0 ? remainder + size : remainder;
}

int clamp(int val, int size)
{
    return std::clamp(val, 0, size - 1);
}

int any_size(Random& random)
{
    constexpr int sizes[] = {1, 2, 3, 5, 6, 7, 8, 64, 100, 1024, 3000, 16384};
    return sizes[random.integer(0, int(std::size(sizes)) - 1)];
}

/// Every value from `first` to `last` periods once with size 6 (the sheet's figure), then random ones.
template <typename Pick>
Group ask(Random& random, int first, int last, Pick const& pick)
{
    std::vector<WrapQuestion> questions;
    for (int val = first; val <= last; ++val)
        questions.push_back({val, 6});
    while (questions.size() < questions_each) {
        int const size = any_size(random);
        questions.push_back({pick(random, size), size});
    }
    return make_group(Kind::wrap, questions);
}

Group ask_inside(Random& random, Textures const&)
{
    return ask(random, 0, 5, [](Random& r, int size) { return r.integer(0, size - 1); });
}

/// Clamping step by step goes by one, repeating by the size.
int repeated(int size)
{
    return farthest(size);
}

int clamped(int size)
{
    return std::max(farthest(1), 2 * size);
}

auto ask_behind(int (*last)(int))
{
    return [=](Random& random, Textures const&) {
        return ask(random, 6, 24,
                   [=](Random& r, int size) { return r.integer(size, r.coin() ? 4 * size : last(size)); });
    };
}

auto ask_negative(int (*last)(int))
{
    return [=](Random& random, Textures const&) {
        return ask(random, -24, -1,
                   [=](Random& r, int size) { return r.integer(r.coin() ? -4 * size : -last(size), -1); });
    };
}

Deviation compare_integers(int measured, int right)
{
    return {measured == right ? 0 : HUGE_VAL, std::to_string(measured), std::to_string(right)};
}

/// Inside the range: the same for every size, and mirrored with the range.
struct MirroredRange {
    std::array<WrapQuestion, 3> questions;  ///< (v, n), (n - 1 - v, n), (v, another n)
};

MirroredRange mirror_range(Random& random)
{
    int const size = random.integer(100, 1000);
    int const val = random.integer(0, size - 1);
    return {{WrapQuestion{val, size}, {size - 1 - val, size}, {val, random.integer(val + 1, 1024)}}};
}

Deviation compare_range(Answers const& answers, MirroredRange const& relation, std::uint32_t const* places)
{
    double const val = integer(answers, places[0]);
    double const mirrored = integer(answers, places[1]);
    double const other = integer(answers, places[2]);
    auto const& [one, two, three] = relation.questions;
    Deviation deviation = compare({mirrored, other}, {one.size - 1 - val, val}, {0, 0});
    deviation.measured = fmt::format("f({}, {}) = {}, f({}, {}) = {}, f({}, {}) = {}", one.val, one.size, val, two.val,
                                     two.size, mirrored, three.val, three.size, other);
    deviation.expected = "f(size - 1 - val, size) = size - 1 - f(val, size), and f(val, larger size) = f(val, size)";
    return deviation;
}

/// Beyond the end, too: a value and one that is whole periods farther.
struct WholePeriods {
    std::array<WrapQuestion, 5> questions;  ///< those of MirroredRange, then (v, n), (v + k n, n)
};

WholePeriods ask_periods(Random& random, Textures const&)
{
    auto const range = mirror_range(random).questions;
    // BeyondTheEnd asks (6, 6) to (24, 6) whatever the seed is: answers that a file may know beforehand.
    bool const known = random.coin();
    int const size = known ? 6 : random.integer(2, 1000);
    WrapQuestion const near{random.integer(size, 4 * size), size};
    WrapQuestion const far{near.val + size * random.integer(1, 100), size};
    return {{range[0], range[1], range[2], near, far}};
}

/// Equal is right. Who repeats too little or not at all keeps the distance: that is BeyondTheEnd's to judge.
Deviation compare_far(Answers const& answers, WholePeriods const& relation, std::uint32_t near, std::uint32_t far)
{
    double const f_near = integer(answers, near);
    double const f_far = integer(answers, far);
    WrapQuestion const a = relation.questions[3];
    WrapQuestion const b = relation.questions[4];
    bool const fits = f_far == f_near || f_far - f_near == b.val - a.val;
    return {fits ? 0 : HUGE_VAL,
            fmt::format("f({}, {}) = {}, f({}, {}) = {}", a.val, a.size, f_near, b.val, b.size, f_far),
            "f(val + k * size, size) = f(val, size)"};
}
}  // namespace

Deviation wrap_clamp_deviation(Answers const& answers, std::uint32_t index, Textures const&, Words)
{
    auto const q = question<WrapQuestion>(answers.group, index);
    return compare_integers(integer(answers, index), clamp(q.val, q.size));
}

Deviation wrap_repeat_deviation(Answers const& answers, std::uint32_t index, Textures const&, Words)
{
    auto const q = question<WrapQuestion>(answers.group, index);
    return compare_integers(integer(answers, index), repeat(q.val, q.size));
}

void add_wrap_checks(std::vector<UnitCheck>& checks)
{
    checks.push_back({"WrapClamp.InsideTheRange", Function::wrap_clamp, ask_inside, judge_by(wrap_clamp_deviation)});
    checks.push_back(
        {"WrapClamp.NegativeIndices", Function::wrap_clamp, ask_negative(clamped), judge_by(wrap_clamp_deviation)});
    checks.push_back(
        {"WrapClamp.BeyondTheEnd", Function::wrap_clamp, ask_behind(clamped), judge_by(wrap_clamp_deviation)});
    checks.push_back(metamorphic_check(
        "WrapClamp.MirroredRange", Function::wrap_clamp, Kind::wrap,
        [](Random& random, Textures const&) { return mirror_range(random); },
        [](Answers const& answers, MirroredRange const& relation, std::array<std::uint32_t, 3> const& places) {
            return compare_range(answers, relation, places.data());
        }));
    checks.push_back({"WrapRepeat.InsideTheRange", Function::wrap_repeat, ask_inside, judge_by(wrap_repeat_deviation)});
    checks.push_back(
        {"WrapRepeat.BeyondTheEnd", Function::wrap_repeat, ask_behind(repeated), judge_by(wrap_repeat_deviation)});
    checks.push_back(
        {"WrapRepeat.NegativeIndices", Function::wrap_repeat, ask_negative(repeated), judge_by(wrap_repeat_deviation)});
    checks.push_back(metamorphic_check(
        "WrapRepeat.WholePeriods", Function::wrap_repeat, Kind::wrap, ask_periods,
        [](Answers const& answers, WholePeriods const& relation, std::array<std::uint32_t, 5> const& places) {
            auto const [one, two, three, near, far] = relation.questions;
            return worst_of({compare_range(answers, {{one, two, three}}, places.data()),
                             compare_far(answers, relation, places[3], places[4])});
        }));
}
}  // namespace testat
