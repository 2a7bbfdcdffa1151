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
    std::string cache() const { return directory.path("texels/a"); }

    TemporaryDirectory directory;
    AssetLibrary library{directory.path()};
};
}  // namespace

TEST(AssetLibrary, EachGammaIsAPictureOfItsOwn)
{
    Folder folder;
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
    Folder folder;
    auto const decoded = AssetLibrary(folder.directory.path()).load("a", 1.f);
    folder.library.cache_texels("a");
    ASSERT_TRUE(std::filesystem::exists(folder.cache()));
    EXPECT_EQ(folder.library.load("a", 1.f)->getPixels(), decoded->getPixels());
}

TEST(AssetLibrary, CacheIsWhatIsRead)
{
    Folder folder;
    folder.library.cache_texels("a");
    std::fstream file(folder.cache(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(-4, std::ios::end);  // the last texel
    file.put(51);
    file.close();
    EXPECT_FLOAT_EQ(folder.library.load("a", 1.f)->getPixel(3, 3).r, 0.2f);
    EXPECT_FLOAT_EQ(folder.library.load("a", 2.f)->texel(3, 3).r, 0.04f);
}

TEST(AssetLibrary, ChangedPictureIsDecodedAgain)
{
    Folder folder;
    folder.library.cache_texels("a");
    numbered_image(5, 4).save(folder.directory.path("a.png"), 1.f);
    EXPECT_EQ(AssetLibrary(folder.directory.path()).load("a", 1.f)->getWidth(), 5);
}

TEST(AssetLibrary, CacheCutShortIsNotUsed)
{
    Folder folder;
    auto const decoded = AssetLibrary(folder.directory.path()).load("a", 1.f);
    folder.library.cache_texels("a");
    std::filesystem::resize_file(folder.cache(), 70);
    EXPECT_EQ(folder.library.load("a", 1.f)->getPixels(), decoded->getPixels());
}

TEST(AssetLibrary, WritingToATextureLeavesTheCacheAlone)
{
    Folder folder;
    folder.library.cache_texels("a");
    auto const first = folder.library.load("a", 1.f);
    first->setPixel(1, 1, glm::vec4(9.f));
    EXPECT_EQ(first->getPixel(1, 1), glm::vec4(9.f));
    EXPECT_NE(folder.library.load("a", 1.f)->getPixel(1, 1), glm::vec4(9.f));
}

TEST(AssetLibrary, PackedTexelsCanBeReadCopiedAndMoved)
{
    Folder folder;
    Image decoded_image;
    decoded_image.load(folder.directory.path("a.png"), 1.f);
    auto const decoded = decoded_image.getPixels();
    folder.library.cache_texels("a");
    auto const packed = folder.library.load("a", 1.f);
    EXPECT_EQ(packed->texel(3, 2), decoded[3 + 2 * 4]);
    Image const copy = *packed;
    EXPECT_EQ(packed->getPixel(3, 2), decoded[3 + 2 * 4]);
    Image const moved = std::move(*packed);
    EXPECT_EQ(copy.getPixels(), decoded);
    EXPECT_EQ(moved.getPixels(), decoded);
}

TEST(AssetLibrary, PictureIsDecodedOnceForAllGammas)
{
    Folder folder;
    auto const first = folder.library.load("a", 1.f)->getPixels();
    std::filesystem::remove(folder.directory.path("a.png"));
    EXPECT_EQ(folder.library.load("a", 1.f)->getPixels(), first);
    EXPECT_LT(folder.library.load("a", 2.f)->getPixel(2, 2).r, first[2 + 2 * 4].r);
}

TEST(AssetLibrary, BufferOfPackedTexelsCanBeReplaced)
{
    Folder folder;
    auto const packed = folder.library.load("a", 1.f);
    std::vector<glm::vec4> other(16, glm::vec4(3.f));
    packed->getPixels() = std::move(other);
    EXPECT_EQ(packed->getPixel(2, 1), glm::vec4(3.f));
    EXPECT_EQ(packed->texel(2, 1), glm::vec4(3.f));
}

TEST(AssetLibrary, PackedTexelsCanBeWritten)
{
    Folder folder;
    folder.library.cache_texels("a");
    auto const packed = folder.library.load("a", 1.f);
    packed->setPixel(0, 0, glm::vec4(5.f));
    packed->getPixels()[1] = glm::vec4(6.f);
    EXPECT_EQ(packed->texel(0, 0), glm::vec4(5.f));
    EXPECT_EQ(packed->texel(1, 0), glm::vec4(6.f));
}

#ifdef HAS_OPENIMAGEIO
TEST(AssetLibrary, TextBesideAPictureIsNoPicture)
{
    TemporaryDirectory const directory;
    numbered_image(4, 2).save(directory.path("a.tif"), 1.f);
    std::ofstream(directory.path("a.credits")) << "painted by nobody";
    EXPECT_EQ(AssetLibrary(directory.path()).load("a", 1.f)->getHeight(), 2);
}

TEST(AssetLibrary, OtherFormatsAreFoundByStem)
{
    TemporaryDirectory const directory;
    numbered_image(4, 2).save(directory.path("a.tif"), 1.f);
    EXPECT_EQ(AssetLibrary(directory.path()).load("a", 1.f)->getHeight(), 2);
}
#endif
