#include <cglib/rt/asset_library.h>

#include "pictures.h"
#include "temporary_directory.h"

#include <gtest/gtest.h>

#include <stdexcept>

TEST(AssetLibrary, PicturesAreDecodedOnce)
{
    TemporaryDirectory const directory;
    numbered_image(4, 4).save(directory.path("a.png"), 1.f);
    AssetLibrary library(directory.path());
    EXPECT_EQ(library.find("a", 1.f), library.find("a", 1.f));
}

TEST(AssetLibrary, EachGammaIsAPictureOfItsOwn)
{
    TemporaryDirectory const directory;
    numbered_image(4, 4).save(directory.path("a.png"), 1.f);
    AssetLibrary library(directory.path());
    EXPECT_GT(library.find("a", 1.f)->getPixel(2, 2).r, library.find("a", 2.2f)->getPixel(2, 2).r);
}

TEST(AssetLibrary, MissingTextureIsNamedWithItsFolder)
{
    TemporaryDirectory const directory;
    AssetLibrary library(directory.path());
    try {
        library.find("wood", 1.f);
        FAIL() << "nothing was thrown";
    } catch (std::runtime_error const& error) {
        std::string const message = error.what();
        EXPECT_NE(message.find("wood"), std::string::npos);
        EXPECT_NE(message.find(directory.path()), std::string::npos);
    }
}

TEST(AssetLibrary, MissingFolderIsAnError)
{
    EXPECT_THROW(AssetLibrary("/nowhere").find("wood", 1.f), std::runtime_error);
}

#ifdef HAS_OPENIMAGEIO
TEST(AssetLibrary, OtherFormatsAreFoundByStem)
{
    TemporaryDirectory const directory;
    numbered_image(4, 2).save(directory.path("a.tif"), 1.f);
    EXPECT_EQ(AssetLibrary(directory.path()).find("a", 1.f)->getHeight(), 2);
}
#endif
