#include "envelopes/mip_levels.h"

#include "answers.h"

#include <gtest/gtest.h>

#include <random>

namespace testat {
namespace {
using Sizes = std::vector<glm::ivec2>;

/// Room for `texels`, header words as given.
Answers claim(std::uint32_t texels, std::vector<std::uint32_t> const& header)
{
    Group group = make_group(Kind::mipmap, std::vector<MipmapQuestion>{{0}});
    group.words_per_answer = MipmapLayout::words(texels);
    Answers answers{group, {}, std::vector<std::uint32_t>(group.answer_size())};
    std::copy(header.begin(), header.end(), answers.words.begin());
    return answers;
}
}  // namespace

TEST(MipSizes, HalveDownToOne)
{
    EXPECT_EQ(mip_sizes({8, 8}), (Sizes{{8, 8}, {4, 4}, {2, 2}, {1, 1}}));
    EXPECT_EQ(mip_sizes({8, 2}), (Sizes{{8, 2}, {4, 1}, {2, 1}, {1, 1}}));
    EXPECT_EQ(mip_sizes({1, 4}), (Sizes{{1, 4}, {1, 2}, {1, 1}}));
    EXPECT_EQ(mip_sizes({1, 1}), (Sizes{{1, 1}}));
}

TEST(MipTexelCount, AddsTheLevelsUp)
{
    EXPECT_EQ(mip_texel_count({8, 8}), 85u);
    EXPECT_EQ(mip_texel_count({8, 2}), 23u);
    EXPECT_EQ(mip_texel_count({1, 1}), 1u);
}

TEST(ReadMipLevels, ReadsSizesAndTexels)
{
    Answers answers = claim(3, {2, 2, 1, 1, 1});
    float const texel[4] = {0.5f, 1, 2, 3};
    std::memcpy(&answers.words[MipmapLayout::header_words + 8], texel, sizeof texel);
    MipLevels const levels = read_mip_levels(answers, 0);
    EXPECT_EQ(levels.count, 2u);
    EXPECT_EQ(levels.sizes, (Sizes{{2, 1}, {1, 1}}));
    EXPECT_EQ(levels.texel(1, 0, 0), glm::dvec4(0.5, 1, 2, 3));
}

TEST(ReadMipLevels, CutsOffWhatDoesNotFit)
{
    EXPECT_EQ(read_mip_levels(claim(4, {2, 2, 2, 1, 1}), 0).sizes, (Sizes{{2, 2}}));
    EXPECT_EQ(read_mip_levels(claim(4, {1, 1u << 15, 1u << 15}), 0).sizes, Sizes{});
    EXPECT_EQ(read_mip_levels(claim(4, {1, 0, 7}), 0).sizes, Sizes{});
    EXPECT_EQ(read_mip_levels(claim(4, {1, 0xffffffffu, 0xffffffffu}), 0).sizes, Sizes{});
}

TEST(ReadMipLevels, DoesNotBelieveImpossibleCounts)
{
    EXPECT_EQ(read_mip_levels(claim(4, {0xffffffffu}), 0).count, 0u);
    EXPECT_EQ(read_mip_levels(claim(4, {unanswered}), 0).count, 0u);
}

TEST(ReadMipLevels, KeepsWithinItsOwnAnswer)
{
    Answers answers = claim(4, {0});
    answers.group.count = 2;
    answers.words.resize(answers.group.answer_size());
    std::uint32_t* second = &answers.words[answers.group.words_per_answer];
    second[0] = 1, second[1] = 2, second[2] = 2;
    EXPECT_EQ(read_mip_levels(answers, 0).sizes, Sizes{});
    EXPECT_EQ(read_mip_levels(answers, 1).texels.size(), 16u);
}

TEST(ReadMipLevels, SurvivesRandomWords)
{
    for (unsigned seed = 0; seed < 2'000; ++seed) {
        std::mt19937 engine(seed);
        std::vector<std::uint32_t> header(MipmapLayout::header_words);
        header[0] = std::uint32_t(engine() % 30);
        for (std::size_t i = 1; i < header.size(); ++i)
            header[i] = engine() % 3 == 0 ? std::uint32_t(engine()) : std::uint32_t(engine() % 5);
        MipLevels const levels = read_mip_levels(claim(64, header), 0);
        ASSERT_LE(levels.texels.size(), 4u * 64) << "seed " << seed;
        ASSERT_EQ(levels.sizes.size(), levels.first.size()) << "seed " << seed;
    }
}
}  // namespace testat
