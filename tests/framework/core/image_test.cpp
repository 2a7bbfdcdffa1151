#include <cglib/core/image.h>

#include "foreign_picture.h"
#include "pictures.h"
#include "temporary_directory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace {
Image saved_and_loaded(Image const& image, float gamma, std::string const& name = "picture.png")
{
    TemporaryDirectory const directory;
    image.save(directory.path(name), gamma);
    Image result;
    result.load(directory.path(name), gamma);
    return result;
}

Image one_pixel(glm::vec4 const& value)
{
    Image image(1, 1);
    image.setPixel(0, 0, value);
    return image;
}

/// The message of the exception that is thrown, empty if there is none.
template <class Function>
std::string failure(Function const& function)
{
    try {
        function();
    } catch (std::runtime_error const& error) {
        return error.what();
    }
    return "";
}
}  // namespace

TEST(Image, NewOneIsZero)
{
    Image const image(3, 2);
    ASSERT_EQ(image.getPixels().size(), 6u);
    EXPECT_EQ(image.getPixel(2, 1), glm::vec4(0.f));
}

TEST(Image, PixelsAreRowMajor)
{
    Image const image = numbered_image(5, 3);
    EXPECT_EQ(image.getPixel(4, 1), image.getPixels()[4 + 1 * 5]);
}

TEST(Image, SetSizeStartsAgainFromZero)
{
    Image image = numbered_image(2, 2);
    image.setSize(1, 4);
    EXPECT_EQ(image.getHeight(), 4);
    EXPECT_EQ(image.getPixel(0, 3), glm::vec4(0.f));
}

TEST(Image, ClearIsOpaqueBlack)
{
    Image image = numbered_image(2, 2);
    image.clear();
    EXPECT_EQ(image.getPixel(1, 0), glm::vec4(0.f, 0.f, 0.f, 1.f));
}

TEST(ImageDeathTest, OutsideIsAsserted)
{
    Image image(3, 2);
    EXPECT_DEATH(image.getPixel(3, 0), "assertion failed");
    EXPECT_DEATH(image.getPixel(-1, 0), "assertion failed");
    EXPECT_DEATH(image.setPixel(0, 2, glm::vec4(0.f)), "assertion failed");
    EXPECT_DEATH(Image(-1, 2), "assertion failed");
}

TEST(Image, EveryByteSurvivesSavingAndLoading)
{
    Image image(256, 1);
    for (float gamma : {1.f, 2.f, 2.2f}) {
        for (int v = 0; v < 256; ++v)
            image.setPixel(v, 0, glm::vec4(glm::vec3(std::pow(float(v) / 255.f, gamma)), 1.f));
        Image const loaded = saved_and_loaded(image, gamma);
        for (int v = 0; v < 256; ++v)
            EXPECT_EQ(loaded.getPixel(v, 0), image.getPixel(v, 0)) << v << " at gamma " << gamma;
    }
}

TEST(Image, GammaBrightensTheFile)
{
    TemporaryDirectory const directory;
    one_pixel(glm::vec4(0.25f, 0.25f, 0.25f, 1.f)).save(directory.path("a.png"), 2.f);
    Image encoded;
    encoded.load(directory.path("a.png"), 1.f);
    EXPECT_FLOAT_EQ(encoded.getPixel(0, 0).r, 128.f / 255.f);
}

TEST(Image, ValuesAreClampedAndNanIsBlack)
{
    Image const loaded = saved_and_loaded(one_pixel(glm::vec4(-3.f, 1e30f, std::nanf(""), 1.f)), 2.2f);
    EXPECT_EQ(loaded.getPixel(0, 0), glm::vec4(0.f, 1.f, 0.f, 1.f));
}

TEST(Image, AlphaIsLinear)
{
    Image const loaded = saved_and_loaded(one_pixel(glm::vec4(1.f, 1.f, 1.f, 51.f / 255.f)), 2.2f);
    EXPECT_FLOAT_EQ(loaded.getPixel(0, 0).w, 0.2f);
}

TEST(Image, PictureWithoutAlphaIsOpaque)
{
    EXPECT_EQ(saved_and_loaded(Image(2, 2), 1.f).getPixel(0, 0).w, 1.f);
}

TEST(Image, RowsAreNotTurnedOver)
{
    Image const image = numbered_image(4, 3);
    Image const loaded = saved_and_loaded(image, 1.f);
    for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(loaded.getPixel(1, j).r, image.getPixel(1, j).r, 1.f / 255.f);
}

TEST(Image, MissingFileIsNamed)
{
    Image image;
    EXPECT_NE(failure([&] { image.load("/nowhere/a.png", 1.f); }).find("/nowhere/a.png"), std::string::npos);
    EXPECT_NE(failure([&] { image.load("/nowhere/a.tif", 1.f); }).find("/nowhere/a.tif"), std::string::npos);
}

TEST(Image, CorruptFileIsNamed)
{
    TemporaryDirectory const directory;
    std::ofstream(directory.path("bad.png")) << "this is no picture";
    Image image;
    EXPECT_NE(failure([&] { image.load(directory.path("bad.png"), 1.f); }).find("bad.png"), std::string::npos);
}

TEST(Image, TruncatedFileIsNamed)
{
    TemporaryDirectory const directory;
    numbered_image(64, 64).save(directory.path("cut.png"), 1.f);
    std::filesystem::resize_file(directory.path("cut.png"), 200);
    Image image;
    EXPECT_NE(failure([&] { image.load(directory.path("cut.png"), 1.f); }).find("cut.png"), std::string::npos);
}

TEST(Image, UnwritablePathIsNamed)
{
    Image const image(4, 4);
    EXPECT_NE(failure([&] { image.save("/nowhere/a.png", 1.f); }).find("/nowhere/a.png"), std::string::npos);
    EXPECT_NE(failure([&] { Image().save("/tmp/framework_empty.png", 1.f); }), "");
}

TEST(Image, FullDiskIsAnError)
{
    TemporaryDirectory const directory;
    std::filesystem::create_symlink("/dev/full", directory.path("a.png"));
    Image const image = numbered_image(64, 64);
    EXPECT_NE(failure([&] { image.save(directory.path("a.png"), 1.f); }).find("a.png"), std::string::npos);
}

#ifdef HAS_OPENIMAGEIO
TEST(Image, FirstRowOfTheFileIsTheLastOfTheImage)
{
    TemporaryDirectory const directory;
    Image const image = numbered_image(4, 3);
    image.save(directory.path("a.png"), 1.f);
    ForeignPicture const picture = read_foreign(directory.path("a.png"));
    ASSERT_EQ(picture.width, 4);
    ASSERT_EQ(picture.height, 3);
    EXPECT_NEAR(picture.rgba[0], image.getPixel(0, 2).r, 0.6f / 255.f);
    EXPECT_NEAR(picture.rgba[4 * 11 + 1], image.getPixel(3, 0).g, 0.6f / 255.f);
}

TEST(Image, OtherFormatsAreReadAndWritten)
{
    Image const image = numbered_image(4, 3);
    for (char const* name : {"a.tif", "a.tga", "a.bmp"}) {
        Image const loaded = saved_and_loaded(image, 2.2f, name);
        ASSERT_EQ(loaded.getWidth(), 4) << name;
        EXPECT_NEAR(loaded.getPixel(3, 1).g, image.getPixel(3, 1).g, 0.01f) << name;
        EXPECT_EQ(loaded.getPixel(3, 1).w, 1.f) << name;
    }
}
#endif
