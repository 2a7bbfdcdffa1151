#include "protocol/questions.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace testat {
TEST(Questions, AreWholeWords)
{
    for (std::uint32_t kind = 0; kind < static_cast<std::uint32_t>(Kind::count); ++kind) {
        EXPECT_GT(question_bytes(static_cast<Kind>(kind)), 0u);
        EXPECT_EQ(question_bytes(static_cast<Kind>(kind)) % 4, 0u);
    }
}

TEST(Questions, HaveTheSizeOfTheirStructs)
{
    EXPECT_EQ(question_bytes(Kind::wrap), sizeof(WrapQuestion));
    EXPECT_EQ(question_bytes(Kind::lookup), sizeof(LookupQuestion));
    EXPECT_EQ(question_bytes(Kind::mipmap), sizeof(MipmapQuestion));
    EXPECT_EQ(question_bytes(Kind::footprint), sizeof(FootprintQuestion));
    EXPECT_EQ(question_bytes(Kind::transform), sizeof(TransformQuestion));
    EXPECT_EQ(question_bytes(Kind::intersect), sizeof(IntersectQuestion));
    EXPECT_EQ(question_bytes(Kind::tangent_space), sizeof(TangentSpaceQuestion));
    EXPECT_EQ(question_bytes(Kind::picture), sizeof(PictureQuestion));
    EXPECT_EQ(question_bytes(Kind::rendering), sizeof(RenderingQuestion));
    EXPECT_EQ(question_bytes(Kind::count), 0u);
}

TEST(Questions, HaveAnswersOfFixedSizeUnlessTheyAskForPictures)
{
    for (Kind kind : {Kind::wrap, Kind::lookup, Kind::footprint, Kind::transform, Kind::intersect, Kind::tangent_space,
                      Kind::rendering})
        EXPECT_GT(answer_words(kind), 0u);
    EXPECT_EQ(answer_words(Kind::mipmap), 0u);
    EXPECT_EQ(answer_words(Kind::picture), 0u);
    EXPECT_EQ(answer_words(Kind::intersect), 2u + 3 * 3u);
}

TEST(MipmapLayout, HasRoomForHeaderAndTexels)
{
    EXPECT_EQ(MipmapLayout::words(0), 1u + 2 * 24);
    EXPECT_EQ(MipmapLayout::words(5) - MipmapLayout::words(4), 4u);
}
}  // namespace testat
