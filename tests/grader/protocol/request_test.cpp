#include "protocol/request.h"

#include "answers.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace testat {
namespace {
Request example()
{
    Request request;
    request.limits = {7, 2, 30};
    request.hanging = FunctionSet::only(Function::intersect);
    request.textures.push_back({1, {{2, 1, {0, 1, 2, 3, 4, 5, 6, 7}}, {1, 1, {8, 9, 10, 11}}}});
    request.textures.push_back({0, {}});
    Group group = make_group(Kind::wrap, std::vector<WrapQuestion>{{-1, 6}, {7, 6}});
    group.name = "WrapRepeat.Example";
    group.from_upload = FunctionSet::only(Function::wrap_repeat);
    group.under_test = Function::wrap_repeat;
    group.culling = false;
    group.fill = 255;
    group.twice = true;
    group.passes = 9;
    request.groups = {group, make_group(Kind::lookup, std::vector<LookupQuestion>{})};
    return request;
}

void expect_equal(Group const& a, Group const& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.from_upload, b.from_upload);
    EXPECT_EQ(a.under_test, b.under_test);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.count, b.count);
    EXPECT_EQ(a.words_per_answer, b.words_per_answer);
    EXPECT_EQ(a.culling, b.culling);
    EXPECT_EQ(a.fill, b.fill);
    EXPECT_EQ(a.twice, b.twice);
    EXPECT_EQ(a.passes, b.passes);
    EXPECT_EQ(a.questions, b.questions);
}

void parse_or_throw(std::vector<std::byte> const& bytes)
{
    try {
        parse_request(bytes);
    } catch (std::runtime_error const&) {
    }
}
}  // namespace

TEST(Request, ComesBackAsItWas)
{
    Request const sent = example();
    Request const received = parse_request(serialize(sent));
    EXPECT_EQ(received.limits.group_s, 7);
    EXPECT_EQ(received.limits.after_timeout_s, 2);
    EXPECT_EQ(received.limits.total_s, 30);
    EXPECT_EQ(received.hanging, sent.hanging);
    ASSERT_EQ(received.textures.size(), 2u);
    EXPECT_EQ(received.textures[0].wrap_mode, 1u);
    ASSERT_EQ(received.textures[0].levels.size(), 2u);
    EXPECT_EQ(received.textures[0].levels[0].texels, sent.textures[0].levels[0].texels);
    EXPECT_EQ(received.textures[0].levels[1].width, 1);
    ASSERT_EQ(received.groups.size(), 2u);
    expect_equal(received.groups[0], sent.groups[0]);
    expect_equal(received.groups[1], sent.groups[1]);
}

TEST(Request, HasOneForm)
{
    EXPECT_EQ(serialize(parse_request(serialize(example()))), serialize(example()));
}

TEST(Request, IsRefusedWhenCutShort)
{
    auto const bytes = serialize(example());
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_THROW(parse_request({bytes.begin(), bytes.begin() + std::ptrdiff_t(length)}), std::runtime_error)
            << length;
}

TEST(Request, IsRefusedWithBytesLeftOver)
{
    auto bytes = serialize(example());
    bytes.push_back(std::byte{0});
    EXPECT_THROW(parse_request(bytes), std::runtime_error);
}

TEST(Request, IsRefusedIfCountAndQuestionsDisagree)
{
    Request request = example();
    ++request.groups[0].count;
    EXPECT_THROW(parse_request(serialize(request)), std::runtime_error);
}

TEST(Request, IsRefusedWithAnUnknownKind)
{
    Request request = example();
    request.groups[1].kind = Kind::count;
    EXPECT_THROW(parse_request(serialize(request)), std::runtime_error);
}

TEST(Request, IsRefusedWithAFillThatIsNoByte)
{
    Request request = example();
    request.groups[0].fill = 256;
    EXPECT_THROW(parse_request(serialize(request)), std::runtime_error);
}

TEST(Request, IsRefusedWithTooManyPasses)
{
    Request request = example();
    request.groups[0].passes = most_passes + 1;
    EXPECT_THROW(parse_request(serialize(request)), std::runtime_error);
}

TEST(Request, SurvivesCorruption)
{
    auto const good = serialize(example());
    for (unsigned seed = 0; seed < 2'000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 engine(seed);
        auto bytes = good;
        for (unsigned i = 1 + engine() % 4; i > 0; --i)
            bytes[engine() % bytes.size()] = std::byte(engine());
        EXPECT_NO_THROW(parse_or_throw(bytes));
    }
}

TEST(Group, CountsTheWordsOfItsAnswers)
{
    EXPECT_EQ(make_group(Kind::lookup, std::vector<LookupQuestion>(3)).answer_size(), 12u);
}
}  // namespace testat
