#include "stress/tally.h"

#include <gtest/gtest.h>

#include <limits>

namespace testat {
namespace {
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Four answers of transform_position.
Answers answers_of(std::vector<float> const& numbers)
{
    Group group = make_group(Kind::transform, std::vector<TransformQuestion>(numbers.size() / 3));
    group.under_test = Function::transform_position;
    Answers answers{group, {}, std::vector<std::uint32_t>(numbers.size())};
    std::memcpy(answers.words.data(), numbers.data(), 4 * numbers.size());
    return answers;
}

/// The first number is how far off the answer is; from 100 on nothing is decided.
Deviation first_number(Answers const& answers, std::uint32_t index, Textures const&, Words words)
{
    double const error = floats<3>(answers, index)[0];
    Deviation deviation{error < 100 ? error : 0, "", "", error < 100};
    if (words == Words::always)
        deviation.measured = std::to_string(index);
    return std::isnan(error) ? Deviation{error, "", "", true} : deviation;
}
}  // namespace

TEST(Tally, CountsAnswersWithNanAndInfinity)
{
    Tally const tally =
        tally_answers(answers_of({nan, nan, 0, 0, infinity, 0, nan, -infinity, 0, 1, 2, 3}), 4, {}, nullptr);
    EXPECT_EQ(tally.counts.nan, 2u);
    EXPECT_EQ(tally.counts.infinite, 2u);
    EXPECT_TRUE(tally.errors.empty());
    EXPECT_FALSE(tally.worst);
}

TEST(Tally, LooksAtNoAnswerThatWasNotGiven)
{
    Tally const tally = tally_answers(answers_of({0, 0, 0, nan, 0, 0}), 1, {}, first_number);
    EXPECT_EQ(tally.counts.nan, 0u);
    EXPECT_EQ(tally.errors.size(), 1u);
}

TEST(Tally, KeepsTheWorstInputInWords)
{
    Tally const tally = tally_answers(answers_of({0.5f, 0, 0, 0.75f, 0, 0, 0.25f, 0, 0}), 3, {}, first_number);
    EXPECT_EQ(tally.worst_error, 0.75);
    EXPECT_EQ(tally.worst->measured, "1");
    EXPECT_NE(tally.worst->input.find("transform ="), std::string::npos) << tally.worst->input;
}

TEST(Tally, TakesNanForInfinitelyWrong)
{
    Tally const tally = tally_answers(answers_of({0.5f, 0, 0, nan, 0, 0}), 2, {}, first_number);
    EXPECT_EQ(tally.worst_error, HUGE_VAL);
    EXPECT_EQ(tally.errors.back(), HUGE_VALF);
}

TEST(Tally, LeavesOutWhatIsUndecided)
{
    Tally const tally = tally_answers(answers_of({0.5f, 0, 0, 200, 0, 0}), 2, {}, first_number);
    EXPECT_EQ(tally.undecided, 1u);
    EXPECT_EQ(tally.errors.size(), 1u);
}

TEST(Tally, IgnoresWhatAMissLeavesBehind)
{
    Group const group = make_group(Kind::intersect, std::vector<IntersectQuestion>(2));
    Answers answers{group, {}, std::vector<std::uint32_t>(group.answer_size(), unanswered)};
    answers.words[0] = 0;
    answers.words[11] = 1;
    EXPECT_EQ(tally_answers(answers, 2, {}, nullptr).counts.nan, 1u);
}

TEST(Tally, AddsUp)
{
    Tally sum = tally_answers(answers_of({0.5f, nan, 0}), 1, {}, first_number);
    sum.add(tally_answers(answers_of({0.25f, nan, 0, 0.75f, 0, 0}), 2, {}, first_number));
    EXPECT_EQ(sum.counts.nan, 2u);
    EXPECT_EQ(sum.errors, (std::vector<float>{0.5f, 0.25f, 0.75f}));
    EXPECT_EQ(sum.worst_error, 0.75);
}
}  // namespace testat
