#include "checks/oracles.h"

#include <algorithm>

namespace testat {
namespace {
constexpr int questions_each = 512;
/// Far enough for every picture, near enough for a loop or a recursion that goes on by `step` again and again.
int farthest(int step)
{
    return std::min(1'000'000, 10'000 * step);
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
    constexpr int sizes[] = {1, 2, 3, 5, 6, 7, 8, 64, 100, 1024};
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
    checks.push_back({"WrapRepeat.InsideTheRange", Function::wrap_repeat, ask_inside, judge_by(wrap_repeat_deviation)});
    checks.push_back(
        {"WrapRepeat.BeyondTheEnd", Function::wrap_repeat, ask_behind(repeated), judge_by(wrap_repeat_deviation)});
    checks.push_back(
        {"WrapRepeat.NegativeIndices", Function::wrap_repeat, ask_negative(repeated), judge_by(wrap_repeat_deviation)});
}
}  // namespace testat
