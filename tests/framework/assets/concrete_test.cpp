#include "texture_files.h"

#include <gtest/gtest.h>

namespace {
float mean_of_column(Image const& image, int x)
{
    float sum = 0.f;
    for (int y = 0; y < image.getHeight(); ++y)
        sum += image.getPixel(x, y).r;
    return sum / float(image.getHeight());
}
}  // namespace

TEST(Concrete, JointsAreDark)
{
    Image const image = texture_file("concrete_diffuse");
    for (int const joint : {128, 384})
        EXPECT_LT(mean_of_column(image, joint), 0.7f * mean_of_column(image, joint + 20));
}

TEST(Concrete, JointsAreDeep)
{
    Image const image = texture_file("concrete_normal");
    for (int const joint : {128, 384}) {
        EXPECT_GT(mean_of_column(image, joint - 3), 0.6f);
        EXPECT_LT(mean_of_column(image, joint + 2), 0.4f);
    }
}
