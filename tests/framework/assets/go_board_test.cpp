#include "texture_files.h"

#include <gtest/gtest.h>

namespace {
int const size = 2048;

/// The texel to the right of the middle of a line; its left neighbour belongs to the line, too.
int line(int i)
{
    return int(float(size) * (0.5f + float(i - 9) * 4.78515625f / 100.f));
}

float brightness(Image const& image, int x, int y)
{
    return image.getPixel(x, y).g;
}
}  // namespace

TEST(GoBoard, LinesAreWhereStonesStand)
{
    Image const image = texture_file("go_board_diffuse");
    for (int i = 0; i < 19; ++i)
        for (int j = 0; j < 18; ++j) {
            int const between = (line(j) + line(j + 1)) / 2;
            EXPECT_LT(brightness(image, line(i), between), 0.2f);
            EXPECT_LT(brightness(image, line(i) - 1, between), 0.2f);
            EXPECT_LT(brightness(image, between, line(i)), 0.2f);
            EXPECT_GT(brightness(image, between, line(i) + 30), 0.3f);
        }
}

TEST(GoBoard, LinesEndAtTheOuterOnes)
{
    Image const image = texture_file("go_board_diffuse");
    for (int i = 0; i < 19; ++i) {
        EXPECT_GT(brightness(image, line(i), line(0) - 8), 0.3f);
        EXPECT_GT(brightness(image, line(18) + 8, line(i)), 0.3f);
    }
}

TEST(GoBoard, StarsAreOnEverySixthLine)
{
    Image const image = texture_file("go_board_diffuse");
    for (int i = 0; i < 19; ++i)
        for (int j = 0; j < 19; ++j) {
            bool const is_star = i % 6 == 3 && j % 6 == 3;
            EXPECT_EQ(brightness(image, line(i) + 5, line(j) + 5) < 0.2f, is_star) << i << ", " << j;
        }
}

TEST(GoBoard, LinesAreEngraved)
{
    Image const image = texture_file("go_board_normal");
    glm::vec3 before(0.f);
    glm::vec3 after(0.f);
    for (int y = line(5) + 10; y < line(6) - 10; ++y)
        for (int i = 1; i < 18; ++i) {
            before += normal_at(image, line(i) - 3, y);
            after += normal_at(image, line(i) + 2, y);
        }
    EXPECT_GT(before.x, 0.2f * before.y);
    EXPECT_LT(after.x, -0.2f * after.y);
}
