#include "stress/numbers.h"
#include "stress/subjects.h"

#include <algorithm>

// wrap_clamp, wrap_repeat. Contract: 1 <= size <= 16384, |val| <= 1e6, so that a loop is slow and not wrong.
namespace testat {
namespace {
constexpr int farthest = 1'000'000;

int any_size(Random& random, int largest)
{
    int const size = static_cast<int>(log_uniform(random, 1, largest + 1.0));
    return random.coin() ? size : 1 << random.integer(0, static_cast<int>(std::log2(largest)));
}

WrapQuestion inside(Random& random)
{
    int const size = any_size(random, 16384);
    switch (random.integer(0, 3)) {
        case 0:  // at a border, many periods away
            return {random.integer(-farthest / size + 1, farthest / size - 1) * size + random.integer(-1, 1), size};
        case 1:
            return {random.integer(-2 * size - 1, 3 * size), size};
        case 2:
            return {pick(random, {0, -1, 1, size, -size, farthest, -farthest}), size};
        default:
            return {static_cast<int>(with_any_sign(random, log_uniform(random, 1, farthest))), size};
    }
}

/// Anywhere between INT_MIN and INT_MAX, both included, and larger sizes.
WrapQuestion outside(Random& random)
{
    constexpr int least = std::numeric_limits<int>::min();
    constexpr int most = std::numeric_limits<int>::max();
    int const size = any_size(random, 1 << 30);
    if (seldom(random, 4))
        return {pick(random, {least, least + 1, most, most - 1, least / 2, most / 2}), size};
    return {static_cast<int>(with_any_sign(random, log_uniform(random, farthest + 1.0, most))), size};
}
}  // namespace

Block wraps_inside(Random& random, std::uint32_t questions)
{
    return make_block<WrapQuestion>(Kind::wrap, random, questions, inside);
}

Block wraps_outside(Random& random, std::uint32_t questions)
{
    return make_block<WrapQuestion>(Kind::wrap, random, questions, outside);
}
}  // namespace testat
