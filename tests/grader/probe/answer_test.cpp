#include "probe/answer.h"

#include "checks/textures.h"
#include "installation.h"
#include "reference_answers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace testat {
namespace {
constexpr std::uint32_t nearest = 0;
constexpr std::uint32_t trilinear = 2;
constexpr auto noise = static_cast<std::uint32_t>(TestTexture::noise_square);
constexpr auto clamp = static_cast<std::uint32_t>(Wrap::clamp);

std::vector<std::uint32_t> rendered(RenderingQuestion const& question)
{
    return reference_answers(make_group(Kind::rendering, std::vector<RenderingQuestion>{question}),
                             make_test_textures(1))
        .words;
}
}  // namespace

TEST(Rendering, IsTheSameWithSeveralThreads)
{
    for (std::uint32_t filter : {nearest, trilinear})
        for (std::uint32_t threads : {2u, 4u, max_threads})
            EXPECT_EQ(rendered({noise, filter, clamp, threads}), rendered({noise, filter, clamp, 1})) << threads;
}

TEST(Rendering, ShowsItsTexture)
{
    auto const words = rendered({noise, nearest, clamp, 1});
    EXPECT_EQ(std::count(words.begin(), words.end(), unanswered), 0);
    EXPECT_GT(std::set<std::uint32_t>(words.begin(), words.end()).size(), 1'000u);
    EXPECT_NE(words, rendered({noise, trilinear, clamp, 1}));
}

TEST(Rendering, IsRefusedIfMalformed)
{
    EXPECT_THROW(rendered({noise, trilinear + 1, clamp, 1}), std::runtime_error);
    EXPECT_THROW(rendered({noise, nearest, 3, 1}), std::runtime_error);
    EXPECT_THROW(rendered({noise, nearest, clamp, 0}), std::runtime_error);
    EXPECT_THROW(rendered({noise, nearest, clamp, max_threads + 1}), std::runtime_error);
    EXPECT_THROW(rendered({1000, nearest, clamp, 1}), std::out_of_range);
}

TEST(Passes, GiveTheSameAnswersAndTheirTime)
{
    LookupQuestion const question{noise, 0, {0.3f, 0.6f}, {0.1f, 0.1f}};
    Group group = make_group(Kind::lookup, std::vector<LookupQuestion>(1000, question));
    group.under_test = Function::evaluate_trilinear;
    auto const once = reference_answers(group, make_test_textures(1)).words;
    AssetLibrary assets(installation().assets.string());
    std::vector<std::uint32_t> words(group.answer_size(), unanswered);
    std::uint32_t answered = 0;
    EXPECT_EQ(answer(group, make_test_textures(1), assets, words.data(), &answered), 0);
    group.passes = 3;
    EXPECT_GT(answer(group, make_test_textures(1), assets, words.data(), &answered), 0);
    EXPECT_EQ(words, once);
    EXPECT_EQ(answered, 1000u);
}

TEST(Mipmaps, AreMadeAnewForEachQuestion)
{
    MipmapQuestion const question{static_cast<std::uint32_t>(TestTexture::mip_small)};
    Group group = make_group(Kind::mipmap, std::vector<MipmapQuestion>{question, question});
    group.words_per_answer = MipmapLayout::words(85);
    auto const words = reference_answers(group, make_test_textures(1)).words;
    auto const second = words.begin() + group.words_per_answer;
    EXPECT_TRUE(std::equal(words.begin(), second, second));
}
}  // namespace testat
