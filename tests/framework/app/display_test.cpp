#include <viewer/display.h>

#include "pictures.h"
#include "temporary_directory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using viewer::DisplayPicture;
using viewer::Exposure;

/// What Image::save writes for the image as it is shown.
Image saved(Image const& image, Exposure const& exposure)
{
    TemporaryDirectory const directory;
    viewer::exposed(image, exposure).save(directory.path("a.png"), exposure.gamma);
    Image stored;
    stored.load(directory.path("a.png"), 1.f);
    return stored;
}
}  // namespace

TEST(Display, ShowsWhatSaveWrites)
{
    Image const image = numbered_image(64, 64);
    for (Exposure const& exposure : {Exposure(), Exposure{1.5f, 2.2f}, Exposure{-2.f, 1.f}}) {
        DisplayPicture picture;
        picture.update(image, {}, exposure);
        Image const file = saved(image, exposure);
        for (std::size_t i = 0; i < image.getPixels().size(); ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(picture.bytes()[4 * i + std::size_t(c)], 255.f * file.getPixels()[i][c], 1.01f);
    }
}

TEST(Display, StrangeColoursHaveTheirPlaces)
{
    viewer::DisplayCurve const curve{Exposure()};
    EXPECT_EQ(curve(-1.f), 0);
    EXPECT_EQ(curve(-0.f), 0);
    EXPECT_EQ(curve(NAN), 0);
    EXPECT_EQ(curve(1.f), 255);
    EXPECT_EQ(curve(1e30f), 255);
    EXPECT_EQ(curve(INFINITY), 255);
}

TEST(Display, ExposureOfNoStopsChangesNoBit)
{
    Image const image = numbered_image(5, 5);
    EXPECT_EQ(viewer::exposed(image, Exposure()).getPixels(), image.getPixels());
}

TEST(Display, OnlyPartsAreUpdatedUntilSomethingElseChanges)
{
    Image image(4, 4);
    DisplayPicture picture;
    EXPECT_TRUE(picture.update(image, {}, Exposure()));
    image.clear(glm::vec4(1.f));
    EXPECT_FALSE(picture.update(image, {}, Exposure()));
    EXPECT_TRUE(picture.update(image, {{1, 0, 2, 1}}, Exposure()));
    EXPECT_EQ(picture.bytes()[0], 0);
    EXPECT_EQ(picture.bytes()[4], 255);
    EXPECT_TRUE(picture.update(image, {}, Exposure{-1.f, 2.2f}));
    EXPECT_EQ(picture.bytes()[0], picture.bytes()[4]);
}
