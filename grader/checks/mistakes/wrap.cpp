#include "checks/mistakes/mistake.h"

#include <algorithm>
#include <cstdlib>

namespace testat {
namespace {
/// The exact integer that a wrong solution gives.
using WrongWrap = int (*)(int val, int size);

Model model(WrongWrap wrong)
{
    return {[=](Answers const& answers, std::uint32_t i, Textures const&) {
                auto const q = question<WrapQuestion>(answers.group, i);
                return integer(answers, i) == wrong(q.val, q.size);
            },
            nullptr};
}

int repeat(int val, int size)
{
    return (val % size + size) % size;
}

int clamp(int val, int size)
{
    return std::clamp(val, 0, size - 1);
}

int to_size(int val, int size)
{
    return std::clamp(val, 0, size);
}

int above_only(int val, int size)
{
    return std::min(val, size - 1);
}

int below_only(int val, int)
{
    return std::max(val, 0);
}

int to_zero(int val, int size)
{
    return val < 0 || val >= size ? 0 : val;
}

int nothing(int val, int)
{
    return val;
}

int abs_of_remainder(int val, int size)
{
    return std::abs(val % size);
}

int plain_remainder(int val, int size)
{
    return val % size;
}

int off_at_multiples(int val, int size)
{
    return val < 0 ? size + val % size : val % size;
}

int one_too_low(int val, int size)
{
    return val < 0 ? size - 1 + val % size : val % size;
}

/// Forth and back: 0 1 2 2 1 0 0 1 2 for size 3.
int mirrored(int val, int size)
{
    int const place = repeat(val, 2 * size);
    return place < size ? place : 2 * size - 1 - place;
}

/// Forth and back without showing the ends twice: 0 1 2 1 0 1 2 for size 3.
int mirrored_at_texels(int val, int size)
{
    if (size == 1)
        return 0;
    int const place = repeat(val, 2 * size - 2);
    return std::min(place, 2 * size - 2 - place);
}

int one_period(int val, int size)
{
    return val < 0 ? val + size : val >= size ? val - size : val;
}
}  // namespace

void add_wrap_mistakes(std::vector<Mistake>& mistakes)
{
    auto const add = [&](char const* id, Function function, std::vector<WrongWrap> const& wrong) {
        Mistake mistake{id, function, {}};
        for (WrongWrap w : wrong)
            mistake.models.push_back(model(w));
        mistakes.push_back(std::move(mistake));
    };
    add("clamp_to_size", Function::wrap_clamp, {to_size});
    add("clamp_above_only", Function::wrap_clamp, {above_only});
    add("clamp_below_only", Function::wrap_clamp, {below_only});
    add("clamp_repeats", Function::wrap_clamp, {repeat});
    add("clamp_to_zero", Function::wrap_clamp, {to_zero});
    add("clamp_does_nothing", Function::wrap_clamp, {nothing});
    add("repeat_abs", Function::wrap_repeat, {abs_of_remainder});
    add("repeat_plain_remainder", Function::wrap_repeat, {plain_remainder});
    add("repeat_off_at_multiples", Function::wrap_repeat, {off_at_multiples});
    add("repeat_one_too_low", Function::wrap_repeat, {one_too_low});
    add("repeat_mirrors", Function::wrap_repeat, {mirrored, mirrored_at_texels});
    add("repeat_one_period_only", Function::wrap_repeat, {one_period});
    add("repeat_clamps", Function::wrap_repeat, {clamp});
}
}  // namespace testat
