#include "envelopes/pictures.h"

#include "answers.h"
#include "envelopes/mip_levels.h"
#include "grey_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace testat {
namespace {
Answers answers_to(std::string const& picture, float value)
{
    Answers answers{picture_group(picture), {}, {}};
    answers.status.ended = Ended::answered;
    std::uint32_t word;
    std::memcpy(&word, &value, sizeof word);
    answers.words.assign(answers.group.answer_size(), word);
    return answers;
}

/// The checker's mip levels, every texel 0.5.
Answers level_answers()
{
    Answers answers = answers_to(miplevels, 0.5f);
    auto const sizes = mip_sizes(glm::ivec2(checker_side));
    answers.words[0] = std::uint32_t(sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        answers.words[1 + 2 * i] = std::uint32_t(sizes[i].x);
        answers.words[2 + 2 * i] = std::uint32_t(sizes[i].y);
    }
    return answers;
}

float pixel(Picture const& picture, glm::ivec2 at)
{
    return picture.rgb[3 * std::size_t(at.y * picture.width + at.x)];
}

std::size_t count_nan(Picture const& picture)
{
    return std::size_t(std::count_if(picture.rgb.begin(), picture.rgb.end(), [](float v) { return std::isnan(v); }));
}
}  // namespace

TEST(PlaceOfLevel, DoesNotOverlap)
{
    std::vector<int> used(std::size_t(checker_side * 3 / 2 * checker_side));
    for (int level = 0; level < checker_levels; ++level) {
        LevelPlace const place = place_of_level(level);
        for (int y = 0; y < place.size.y; ++y)
            for (int x = 0; x < place.size.x; ++x)
                ++used.at(std::size_t((place.corner.y + y) * checker_side * 3 / 2 + place.corner.x + x));
    }
    EXPECT_EQ(*std::max_element(used.begin(), used.end()), 1);
}

TEST(PlaceOfLevel, HasTheSizesOfMipLevels)
{
    auto const sizes = mip_sizes(glm::ivec2(checker_side));
    ASSERT_EQ(sizes.size(), std::size_t(checker_levels));
    for (int level = 0; level < checker_levels; ++level)
        EXPECT_EQ(place_of_level(level).size, sizes[std::size_t(level)]) << level;
}

TEST(PictureGroup, AsksForOnePictureByName)
{
    Group const group = picture_group("plane_after_c");
    EXPECT_EQ(group.count, 1u);
    EXPECT_EQ(group.answer_size(), 256u * 256 * 3);
    EXPECT_STREQ(question<PictureQuestion>(group, 0).name, "plane_after_c");
}

TEST(PictureGroup, TerminatesLongNames)
{
    auto const q = question<PictureQuestion>(picture_group(std::string(100, 'x')), 0);
    EXPECT_EQ(q.name[sizeof q.name - 1], '\0');
}

TEST(ReadPicture, GivesTheWordsAsFloats)
{
    auto const picture = read_picture(answers_to("plane_after_c", 0.25f));
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 256);
    EXPECT_EQ(picture->rgb, grey_picture(256, 256, 0.25f).rgb);
}

TEST(ReadPicture, GivesNothingUnlessAnswered)
{
    Answers answers = answers_to("plane_after_c", 0.25f);
    for (Ended ended :
         {Ended::signal, Ended::exit, Ended::exception, Ended::timed_out, Ended::not_loaded, Ended::lost}) {
        answers.status.ended = ended;
        EXPECT_FALSE(read_picture(answers));
    }
}

TEST(ReadPicture, DrawsMipLevelsBesideEachOther)
{
    auto const picture = read_picture(level_answers());
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 192);
    EXPECT_EQ(picture->height, 128);
    for (int level = 0; level < checker_levels; ++level)
        EXPECT_EQ(pixel(*picture, place_of_level(level).corner), 0.5f) << level;
    EXPECT_EQ(count_nan(*picture), 0u);
}

TEST(ReadPicture, DrawsNaNWhereALevelIsMissing)
{
    Answers answers = level_answers();
    answers.words[0] = 7;
    auto const picture = read_picture(answers);
    EXPECT_TRUE(std::isnan(pixel(*picture, place_of_level(7).corner)));
    EXPECT_EQ(count_nan(*picture), 3u);
}

TEST(ReadPicture, DrawsNaNWhereALevelHasAnotherSize)
{
    Answers answers = level_answers();
    std::swap(answers.words[3], answers.words[4]);
    answers.words[4] = 32;  // level 1 is 64 x 32
    auto const picture = read_picture(answers);
    EXPECT_TRUE(std::isnan(pixel(*picture, place_of_level(1).corner)));
    EXPECT_EQ(count_nan(*picture), 3u * 64 * 64);
    EXPECT_EQ(pixel(*picture, place_of_level(2).corner), 0.5f);
}

TEST(ReadPicture, DrawsNaNForWordsThatWereNeverWritten)
{
    Answers answers = level_answers();
    std::fill(answers.words.begin(), answers.words.end(), unanswered);
    EXPECT_EQ(count_nan(*read_picture(answers)), 3 * mip_texel_count(glm::ivec2(checker_side)));
}
}  // namespace testat
