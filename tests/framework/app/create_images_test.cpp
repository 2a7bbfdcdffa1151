// Runs 03_textures as students do.
#include "textures_run.h"

#include <cglib/core/image.h>
#include <cglib/rt/assignment_images.h>

#include <gtest/gtest.h>

TEST(CreateImages, BothSpellingsWriteAllPictures)
{
    for (char const* option : {"--create_images", "--create-images"}) {
        TexturesRun run(TEXTURES_PROGRAM);
        EXPECT_EQ(run.exit_code(option), 0) << run.err();
        EXPECT_EQ(run.num_images(), int(assignment_images().size()) + num_miplevel_images);
        EXPECT_EQ(run.err(), "");
    }
}

TEST(CreateImages, PicturesHaveTheirSizes)
{
    TexturesRun run(TEXTURES_PROGRAM);
    ASSERT_EQ(run.exit_code("--create_images"), 0);
    Image image;
    for (AssignmentImage const& assignment : assignment_images()) {
        image.load(run.image(assignment.name), 1.f);
        EXPECT_EQ(image.getWidth(), 256) << assignment.name;
    }
    for (int level = 0; level < num_miplevel_images; ++level) {
        image.load(run.image(miplevel_image_name(level)), 1.f);
        EXPECT_EQ(image.getHeight(), 128 >> level);
    }
}

TEST(CreateImages, TwoRunsWriteTheSameBytes)
{
    TexturesRun first(TEXTURES_PROGRAM);
    TexturesRun second(TEXTURES_PROGRAM);
    ASSERT_EQ(first.exit_code("--create_images"), 0);
    ASSERT_EQ(second.exit_code("--create_images"), 0);
    for (AssignmentImage const& assignment : assignment_images())
        EXPECT_EQ(contents(first.image(assignment.name)), contents(second.image(assignment.name)));
}

TEST(CreateImages, UntouchedTemplateIsToldWhichLevelsItLacks)
{
    TexturesRun run(TEMPLATE_PROGRAM);
    EXPECT_EQ(run.exit_code("--create_images"), 0);
    EXPECT_TRUE(std::filesystem::exists(run.image("miplevel00")));
    EXPECT_FALSE(std::filesystem::exists(run.image("miplevel01")));
    EXPECT_NE(run.err().find("miplevel01"), std::string::npos);
    EXPECT_NE(run.err().find("miplevel07"), std::string::npos);
}

TEST(CreateImages, FolderThatCannotBeMadeIsAnError)
{
    TexturesRun run(TEXTURES_PROGRAM);
    std::ofstream(run.directory.path("assignment_images")) << "a file is in the way";
    EXPECT_EQ(run.exit_code("--create_images"), 2);
    EXPECT_NE(run.err().find("assignment_images"), std::string::npos);
}

TEST(CreateImages, PictureThatCannotBeWrittenIsAnError)
{
    TexturesRun run(TEXTURES_PROGRAM);
    std::filesystem::create_directories(run.image("plane_after_c"));
    EXPECT_EQ(run.exit_code("--create_images"), 2);
    EXPECT_NE(run.err().find("plane_after_c.png"), std::string::npos);
}
