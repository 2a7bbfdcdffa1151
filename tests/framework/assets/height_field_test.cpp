#include "height_field.h"

#include "texture_files.h"

#include <gtest/gtest.h>

namespace {
/// Grows by 0.5 along u and by 0.25 along v.
HeightField slope(Border border)
{
    return HeightField(8, 4, border, [](int x, int y) { return 0.5f * float(x) + 0.25f * float(y); });
}
}  // namespace

TEST(HeightField, SlopeIsInTexels)
{
    EXPECT_EQ(slope(Border::clamp).slope(3, 2), glm::vec2(0.5f, 0.25f));
}

TEST(HeightField, RepeatsOrKeepsItsBorder)
{
    EXPECT_EQ(slope(Border::repeat).at(-1, 0), 3.5f);
    EXPECT_EQ(slope(Border::repeat).at(0, 4), 0.f);
    EXPECT_EQ(slope(Border::clamp).at(-1, 0), 0.f);
    EXPECT_EQ(slope(Border::clamp).at(0, 4), 0.75f);
}

TEST(HeightField, BlurTakesMeansOfSquares)
{
    HeightField const field(8, 4, Border::repeat, [](int x, int y) { return x == 7 && y == 1 ? 9.f : 0.f; });
    HeightField const blurred = field.blurred(1);
    EXPECT_EQ(blurred.width(), 8);
    EXPECT_EQ(blurred.height(), 4);
    EXPECT_NEAR(blurred.at(0, 0), 1.f, 1e-5f);
    EXPECT_NEAR(blurred.at(6, 2), 1.f, 1e-5f);
    EXPECT_NEAR(blurred.at(1, 1), 0.f, 1e-5f);
}

TEST(NormalMap, LeansAgainstTheSlope)
{
    glm::vec3 const expected = glm::normalize(glm::vec3(-0.5f, 1.f, -0.25f));
    glm::vec3 const normal = normal_at(make_normal_map(slope(Border::clamp), Bitangent::along_v), 3, 2);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(normal[i], expected[i], 0.005f);
}

TEST(NormalMap, FollowsTheBitangent)
{
    Image const along = make_normal_map(slope(Border::clamp), Bitangent::along_v);
    Image const against = make_normal_map(slope(Border::clamp), Bitangent::against_v);
    EXPECT_EQ(normal_at(along, 3, 2).x, normal_at(against, 3, 2).x);
    EXPECT_NEAR(normal_at(along, 3, 2).z, -normal_at(against, 3, 2).z, 0.005f);
}

TEST(NormalMap, FlatIsBlue)
{
    HeightField const flat(2, 2, Border::repeat, [](int, int) { return 3.f; });
    Image const image = make_normal_map(flat, Bitangent::along_v);
    EXPECT_EQ(image.getPixel(1, 0), glm::vec4(128.f / 255.f, 128.f / 255.f, 1.f, 1.f));
}
