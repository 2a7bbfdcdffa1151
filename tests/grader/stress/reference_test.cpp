// The reference on inputs that its contract allows: finite, and inside its bounds. Built with sanitizers this is the
// test that none of them has anything to say.
#include "reference_answers.h"
#include "stress/stress.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace testat {
namespace {
/// Of the cheap functions; a few blocks, because some keep the same textures or sizes for a block.
constexpr std::uint32_t questions = 20'000;
constexpr std::uint32_t blocks = 8;

class Reference : public testing::TestWithParam<Subject> {};

std::uint32_t questions_to_a_block()
{
    double const share = double(Reference::GetParam().questions) / most_questions;
    return std::max(8u, static_cast<std::uint32_t>(questions * share / blocks));
}

Tally stress_reference(std::uint64_t seed)
{
    Tally tally;
    for (std::uint32_t i = 0; i < blocks; ++i) {
        Block const block = stress_block(Reference::GetParam(), true, i, questions_to_a_block(), seed);
        Answers const answers = reference_answers(block.group, block.textures);
        tally.add(tally_answers(answers, block.group.count, block.textures, Reference::GetParam().oracle));
    }
    return tally;
}

TEST_P(Reference, StaysInsideItsBounds)
{
    for (std::uint64_t seed : {1, 2, 3}) {
        Tally const tally = stress_reference(seed);
        EXPECT_LT(tally.worst_error, 1) << tally.worst->input << "\nmeasured " << tally.worst->measured << "\nexpected "
                                        << tally.worst->expected << "\nseed " << seed;
        EXPECT_EQ(tally.counts.nan, 0u);
        EXPECT_EQ(tally.counts.infinite, 0u);
    }
}

/// A bound that is never anywhere near would allow mistakes, and so would questions that are left undecided.
TEST_P(Reference, HasBoundsThatMeanSomething)
{
    Tally const tally = stress_reference(4);
    bool const in_whole_numbers =
        GetParam().oracle == wrap_clamp_deviation || GetParam().oracle == wrap_repeat_deviation;
    EXPECT_GT(tally.worst_error, in_whole_numbers ? -1 : 0.1);
    EXPECT_LT(5 * tally.undecided, tally.undecided + tally.errors.size());
}

INSTANTIATE_TEST_SUITE_P(Functions, Reference, testing::ValuesIn(subjects()),
                         [](auto const& p) { return std::string(testat::info(p.param.function).name); });
}  // namespace
}  // namespace testat
