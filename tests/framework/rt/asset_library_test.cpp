#include <cglib/rt/asset_library.h>

#include "pictures.h"
#include "temporary_directory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace {
/// A folder with a picture `a` of 4 x 4 pixels.
struct Folder {
    Folder() { numbered_image(4, 4).save(directory.path("a.png"), 1.f); }
    std::string cache() const { return directory.path("texels/a-1"); }

    TemporaryDirectory directory;
    AssetLibrary library{directory.path()};
};
}  // namespace

TEST(AssetLibrary, EachGammaIsAPictureOfItsOwn)
{
    Folder const folder;
    EXPECT_GT(folder.library.load("a", 1.f)->getPixel(2, 2).r, folder.library.load("a", 2.2f)->getPixel(2, 2).r);
}

TEST(AssetLibrary, MissingTextureIsNamedWithItsFolder)
{
    TemporaryDirectory const directory;
    try {
        AssetLibrary(directory.path()).load("wood", 1.f);
        FAIL() << "nothing was thrown";
    } catch (std::runtime_error const& error) {
        std::string const message = error.what();
        EXPECT_NE(message.find("wood"), std::string::npos);
        EXPECT_NE(message.find(directory.path()), std::string::npos);
    }
}

TEST(AssetLibrary, MissingFolderIsAnError)
{
    EXPECT_THROW(AssetLibrary("/nowhere").load("wood", 1.f), std::runtime_error);
}

TEST(AssetLibrary, CachedTexelsAreThoseOfThePicture)
{
    Folder const folder;
    auto const decoded = folder.library.load("a", 1.f);
    folder.library.cache_texels("a", 1.f);
    ASSERT_TRUE(std::filesystem::exists(folder.cache()));
    EXPECT_EQ(folder.library.load("a", 1.f)->getPixels(), decoded->getPixels());
}

TEST(AssetLibrary, CacheIsWhatIsRead)
{
    Folder const folder;
    folder.library.cache_texels("a", 1.f);
    std::fstream file(folder.cache(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(4096);
    float const marked = 7.f;
    file.write(reinterpret_cast<char const*>(&marked), sizeof marked);
    file.close();
    EXPECT_EQ(folder.library.load("a", 1.f)->getPixel(0, 0).r, marked);
}

TEST(AssetLibrary, ChangedPictureIsDecodedAgain)
{
    Folder const folder;
    folder.library.cache_texels("a", 1.f);
    numbered_image(5, 4).save(folder.directory.path("a.png"), 1.f);
    EXPECT_EQ(folder.library.load("a", 1.f)->getWidth(), 5);
}

TEST(AssetLibrary, CacheCutShortIsNotUsed)
{
    Folder const folder;
    auto const decoded = folder.library.load("a", 1.f);
    folder.library.cache_texels("a", 1.f);
    std::filesystem::resize_file(folder.cache(), 4096 + 5);
    EXPECT_EQ(folder.library.load("a", 1.f)->getPixels(), decoded->getPixels());
}

TEST(AssetLibrary, WritingToAMappedTextureLeavesTheCacheAlone)
{
    Folder const folder;
    folder.library.cache_texels("a", 1.f);
    auto const first = folder.library.load("a", 1.f);
    first->setPixel(1, 1, glm::vec4(9.f));
    EXPECT_EQ(first->getPixel(1, 1), glm::vec4(9.f));
    EXPECT_NE(folder.library.load("a", 1.f)->getPixel(1, 1), glm::vec4(9.f));
}

TEST(AssetLibrary, MappedTextureCanBeCopiedMovedAndReleased)
{
    Folder const folder;
    auto const decoded = folder.library.load("a", 1.f)->getPixels();
    folder.library.cache_texels("a", 1.f);
    auto const mapped = folder.library.load("a", 1.f);
    Image const copy = *mapped;
    mapped->release();
    EXPECT_EQ(mapped->getPixel(3, 2), decoded[3 + 2 * 4]);
    Image const moved = std::move(*mapped);
    EXPECT_EQ(copy.getPixels(), decoded);
    EXPECT_EQ(moved.getPixels(), decoded);
}

TEST(AssetLibrary, AllPixelsOfAMappedTextureCanBeWritten)
{
    Folder const folder;
    folder.library.cache_texels("a", 1.f);
    auto const mapped = folder.library.load("a", 1.f);
    mapped->setPixel(0, 0, glm::vec4(5.f));
    EXPECT_EQ(mapped->getPixels()[0], glm::vec4(5.f));
    mapped->getPixels()[1] = glm::vec4(6.f);
    mapped->release();
    EXPECT_EQ(mapped->getPixel(1, 0), glm::vec4(6.f));
}

#ifdef HAS_OPENIMAGEIO
TEST(AssetLibrary, OtherFormatsAreFoundByStem)
{
    TemporaryDirectory const directory;
    numbered_image(4, 2).save(directory.path("a.tif"), 1.f);
    EXPECT_EQ(AssetLibrary(directory.path()).load("a", 1.f)->getHeight(), 2);
}
#endif
