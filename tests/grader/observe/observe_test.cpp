#include "observe/observe.h"

#include "answers.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace testat {
namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two groups of two one-word answers each.
Request example()
{
    Request request;
    for (char const* name : {"first", "second"}) {
        request.groups.push_back(make_group(Kind::wrap, std::vector<WrapQuestion>{{1, 2}, {3, 2}}));
        request.groups.back().name = name;
    }
    return request;
}

class Stream {
public:
    template <typename T>
    Stream& put(T const& value)
    {
        auto const* begin = reinterpret_cast<std::byte const*>(&value);
        bytes.insert(bytes.end(), begin, begin + sizeof value);
        return *this;
    }
    Stream& group(GroupStatus const& status, std::uint32_t a, std::uint32_t b) { return put(status).put(a).put(b); }
    std::vector<std::byte> bytes;
};

GroupStatus whole()
{
    GroupStatus status;
    status.ended = Ended::answered;
    status.answered = 2;
    status.cpu_s = 0.5;
    status.work_s = 0.25;
    return status;
}

/// The first group's answers when the probe says this of it.
GroupStatus decoded(GroupStatus const& status)
{
    Stream stream;
    stream.put(greeting).group(status, 1, 2).group(whole(), 3, 4);
    return decode_answers(example(), stream.bytes).groups.at("first").status;
}
}  // namespace

TEST(DecodeAnswers, GivesEveryGroupItsWords)
{
    Stream stream;
    stream.put(greeting).group(whole(), 1, 2).group(whole(), 3, 4);
    auto const seen = decode_answers(example(), stream.bytes);
    EXPECT_EQ(seen.groups.at("first").words, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(seen.groups.at("second").words, (std::vector<std::uint32_t>{3, 4}));
    EXPECT_EQ(seen.groups.at("second").status.ended, Ended::answered);
    EXPECT_EQ(seen.groups.at("second").status.work_s, 0.25);
}

TEST(DecodeAnswers, ThrowsWithoutGreeting)
{
    EXPECT_THROW(decode_answers(example(), {}), std::runtime_error);
    EXPECT_THROW(decode_answers(example(), std::vector<std::byte>(3)), std::runtime_error);
    EXPECT_THROW(decode_answers(example(), Stream().put(greeting + 1).group(whole(), 1, 2).bytes), std::runtime_error);
}

TEST(DecodeAnswers, LeavesTheRestLostWhereTheStreamEnds)
{
    auto const bytes = Stream().put(greeting).group(whole(), 1, 2).group(whole(), 3, 4).bytes;
    std::size_t const second = 4 + sizeof(GroupStatus) + 8;
    for (std::size_t length = 4; length < bytes.size(); ++length) {
        auto const seen = decode_answers(example(), {bytes.begin(), bytes.begin() + std::ptrdiff_t(length)});
        EXPECT_EQ(seen.groups.at("first").status.ended, length < second ? Ended::lost : Ended::answered) << length;
        EXPECT_EQ(seen.groups.at("second").status.ended, Ended::lost) << length;
        EXPECT_EQ(seen.groups.at("second").words, std::vector<std::uint32_t>(2, unanswered)) << length;
    }
}

TEST(DecodeAnswers, TakesAnUnknownEndForLost)
{
    GroupStatus status = whole();
    status.ended = Ended::count;
    EXPECT_EQ(decoded(status).ended, Ended::lost);
    status.ended = static_cast<Ended>(0xffffffffu);
    EXPECT_EQ(decoded(status).ended, Ended::lost);
}

TEST(DecodeAnswers, CountsNoMoreAnswersThanQuestions)
{
    GroupStatus status = whole();
    status.answered = 0xffffffffu;
    EXPECT_EQ(decoded(status).answered, 2u);
}

TEST(DecodeAnswers, TakesImpossibleTimesForZero)
{
    for (double wrong : {nan, -1.0, 1e9, std::numeric_limits<double>::infinity()}) {
        GroupStatus status = whole();
        status.cpu_s = wrong;
        EXPECT_EQ(decoded(status).cpu_s, 0) << wrong;
        EXPECT_EQ(decoded(status).work_s, 0) << wrong;
    }
}

TEST(DecodeAnswers, TakesNoMoreWorkThanTime)
{
    for (double wrong : {nan, -1.0, 0.75}) {
        GroupStatus status = whole();
        status.work_s = wrong;
        EXPECT_EQ(decoded(status).work_s, 0.5) << wrong;
    }
}

TEST(DecodeAnswers, KnowsNoPassThatTookMoreThanAll)
{
    for (double wrong : {nan, -1.0, 0.75, std::numeric_limits<double>::infinity()}) {
        GroupStatus status = whole();
        status.pass_s = wrong;
        EXPECT_EQ(decoded(status).pass_s, 0) << wrong;
    }
    GroupStatus status = whole();
    status.pass_s = 0.125;
    EXPECT_EQ(decoded(status).pass_s, 0.125);
}

TEST(DecodeAnswers, TakesImpossibleGrowthForNone)
{
    for (double wrong : {nan, 1e15, -std::numeric_limits<double>::infinity()}) {
        GroupStatus status = whole();
        status.kept = wrong;
        EXPECT_EQ(decoded(status).kept, 0) << wrong;
    }
    GroupStatus status = whole();
    status.kept = 4096;
    EXPECT_EQ(decoded(status).kept, 4096);
}

TEST(DecodeAnswers, KeepsTextsWithoutTerminator)
{
    GroupStatus status = whole();
    std::fill(std::begin(status.text), std::end(status.text), 'x');
    EXPECT_EQ(decoded(status).text[sizeof status.text - 1], 'x');
}

TEST(DecodeAnswers, SurvivesRandomStreams)
{
    for (unsigned seed = 0; seed < 2'000; ++seed) {
        std::mt19937 engine(seed);
        auto bytes = Stream().put(greeting).bytes;
        bytes.resize(4 + engine() % (2 * sizeof(GroupStatus) + 40));
        for (std::size_t i = 4; i < bytes.size(); ++i)
            bytes[i] = std::byte(engine());
        for (auto const& [name, answers] : decode_answers(example(), bytes).groups) {
            ASSERT_LT(answers.status.ended, Ended::count) << "seed " << seed;
            ASSERT_EQ(answers.words.size(), 2u) << "seed " << seed;
        }
    }
}
}  // namespace testat
