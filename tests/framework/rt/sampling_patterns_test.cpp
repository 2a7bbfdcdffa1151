#include <cglib/rt/sampling_patterns.h>

#include <gtest/gtest.h>

TEST(SamplingPattern, OneSampleIsTheCentre)
{
    ThreadLocalData thread;
    EXPECT_EQ(sampling_pattern(1, false, thread), std::vector<glm::vec2>{glm::vec2(0.5f)});
}

TEST(SamplingPattern, SamplesAreInThePixel)
{
    ThreadLocalData thread(3);
    for (glm::vec2 const& p : sampling_pattern(1000, false, thread))
        EXPECT_TRUE(p.x >= 0.f && p.x < 1.f && p.y >= 0.f && p.y < 1.f);
}

TEST(SamplingPattern, StratifiedFillsEachCell)
{
    ThreadLocalData thread(3);
    int counts[3][3] = {};
    for (glm::vec2 const& p : sampling_pattern(11, true, thread))
        ++counts[int(3.f * p.y)][int(3.f * p.x)];
    for (auto const& row : counts)
        for (int count : row)
            EXPECT_GE(count, 1);
}
