// The options of 03_textures.
#include "textures_run.h"

#include <cglib/core/image.h>

#include <gtest/gtest.h>

#include <vector>

namespace {
/// The picture that the options give, read back as stored.
Image picture(std::string const& options)
{
    TexturesRun run(TEXTURES_PROGRAM);
    EXPECT_EQ(run.exit_code("--output a.png --width 24 --height 16 " + options), 0) << options << run.err();
    Image image;
    image.load(run.directory.path("a.png"), 1.f);
    return image;
}
}  // namespace

TEST(CommandLine, UnknownOptionIsAnError)
{
    TexturesRun run(TEXTURES_PROGRAM);
    EXPECT_EQ(run.exit_code("--create_imges"), 2);
    EXPECT_NE(run.err().find("--create_imges"), std::string::npos);
}

TEST(CommandLine, ValueThatIsNoneIsAnError)
{
    TexturesRun run(TEXTURES_PROGRAM);
    for (char const* wrong : {"--scene moon", "--filter cubic", "--filter 1", "--wrap 7up", "--mode x", "--width 0",
                              "--height -3", "--spp 0", "--depth -1", "--threads 0", "--width 1e9", "stray"})
        EXPECT_EQ(run.exit_code("--output a.png " + std::string(wrong)), 2) << wrong;
}

TEST(CommandLine, ErrorsNameTheChoices)
{
    TexturesRun run(TEXTURES_PROGRAM);
    run.exit_code("--output a.png --scene moon");
    EXPECT_NE(run.err().find("pooltable"), std::string::npos);
    run.exit_code("--output a.png --filter cubic");
    EXPECT_NE(run.err().find("cubic is none of bilinear, debugmip, nearest, trilinear"), std::string::npos)
        << run.err();
}

TEST(CommandLine, ListNamesScenesAndPictures)
{
    TexturesRun run(TEXTURES_PROGRAM);
    EXPECT_EQ(run.exit_code("--list"), 0);
    for (char const* name : {"goboard", "triangles", "pooltable_after_e", "miplevel07"})
        EXPECT_NE(run.out().find(name), std::string::npos) << name;
}

TEST(CommandLine, PictureHasTheSizeAskedFor)
{
    Image const image = picture("--scene sphere");
    EXPECT_EQ(image.getWidth(), 24);
    EXPECT_EQ(image.getHeight(), 16);
}

TEST(CommandLine, EachChoiceChangesThePicture)
{
    std::vector<std::string> const options = {"",
                                              "--filter bilinear",
                                              "--filter trilinear",
                                              "--filter debugmip",
                                              "--filter white",
                                              "--mode normal",
                                              "--mode desaturate",
                                              "--mode numrays",
                                              "--mode dudv --filter trilinear",
                                              "--spp 4",
                                              "--spp 4 --stratified",
                                              "--depth 0",
                                              "--normal_mapping",
                                              "--no_transforms"};
    std::vector<Image> pictures;
    for (std::string const& option : options) {
        pictures.push_back(picture("--scene goboard " + option));
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i)
            EXPECT_FALSE(pictures[i].getPixels() == pictures.back().getPixels()) << option << " / " << options[i];
    }
}

TEST(CommandLine, EachWrapChangesThePicture)
{
    Image const repeat = picture("--scene plane");
    Image const clamp = picture("--scene plane --wrap clamp");
    EXPECT_FALSE(repeat.getPixels() == clamp.getPixels());
    EXPECT_FALSE(clamp.getPixels() == picture("--scene plane --wrap zero").getPixels());
}

TEST(CommandLine, ThreadsDoNotChangeThePicture)
{
    EXPECT_EQ(picture("--scene pooltable --threads 1").getPixels(),
              picture("--scene pooltable --threads 8").getPixels());
}

TEST(CommandLine, UnwritableOutputIsAnError)
{
    TexturesRun run(TEXTURES_PROGRAM);
    EXPECT_EQ(run.exit_code("--output nowhere/a.png"), 2);
    EXPECT_NE(run.err().find("nowhere/a.png"), std::string::npos);
    for (char const* other : {"a.foo", "a", ".", "a.bmp"}) {
        EXPECT_EQ(run.exit_code("--output " + std::string(other)), 2) << other;
        EXPECT_NE(run.err().find(".png"), std::string::npos) << run.err();
    }
}

TEST(CommandLine, WhatCannotBePrintedIsAnError)
{
    TexturesRun run(TEXTURES_PROGRAM);
    EXPECT_EQ(run.exit_code("--list > /dev/full; exit $?; true"), 2);
}

TEST(CommandLine, PicturesOfTheSheetHaveTheirOwnNumbers)
{
    TexturesRun run(TEXTURES_PROGRAM);
    EXPECT_EQ(run.exit_code("--create_images --width 100"), 2);
    EXPECT_NE(run.err().find("--width"), std::string::npos);
}

TEST(CommandLine, MissingTextureIsNamed)
{
    TexturesRun run(TEXTURES_PROGRAM);
    std::filesystem::create_directory(run.directory.path("empty"));
    EXPECT_EQ(run.exit_code("--assets empty --scene sphere --output a.png"), 2);
    EXPECT_NE(run.err().find("stonewall_diffuse"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(run.directory.path("a.png")));
}

TEST(CommandLine, AssetsSwapTexturesByStem)
{
    TexturesRun run(TEXTURES_PROGRAM);
    Image red(2, 2);
    red.clear(glm::vec4(1.f, 0.f, 0.f, 1.f));
    std::filesystem::create_directory(run.directory.path("mine"));
    red.save(run.directory.path("mine/checker.png"), 1.f);
    ASSERT_EQ(run.exit_code("--assets mine --scene plane --output a.png --width 9 --height 9"), 0) << run.err();
    Image image;
    image.load(run.directory.path("a.png"), 1.f);
    EXPECT_GT(image.getPixel(4, 4).r, 0.f);
    EXPECT_EQ(image.getPixel(4, 4).g, 0.f);
}

TEST(CommandLine, StatsAreCounts)
{
    TexturesRun run(TEXTURES_PROGRAM);
    ASSERT_EQ(run.exit_code("--stats --scene plane --output a.png --width 10 --height 10"), 0);
    EXPECT_NE(run.out().find("camera rays"), std::string::npos);
    EXPECT_NE(run.out().find("         100\n"), std::string::npos) << run.out();
}
