// What the solution shows today is what references/images keeps.
#include "textures_run.h"

#include <cglib/core/image.h>
#include <cglib/rt/assignment_images.h>

#include <gtest/gtest.h>

namespace {
std::vector<std::string> names()
{
    std::vector<std::string> names;
    for (AssignmentImage const& picture : assignment_images())
        names.push_back(picture.name);
    for (int level = 0; level < num_miplevel_images; ++level)
        names.push_back(miplevel_image_name(level));
    return names;
}

std::string kept(std::string const& name)
{
    return REFERENCE_IMAGES + ("/" + name + ".png");
}

/// As stored: v/255.
Image stored(std::string const& path)
{
    Image image;
    image.load(path, 1.f);
    return image;
}
}  // namespace

TEST(ReferenceImages, AreTheTwentySevenOfTheSheet)
{
    std::vector<std::string> const all = names();
    EXPECT_EQ(all.size(), 27u);
    auto const files = std::filesystem::directory_iterator(REFERENCE_IMAGES);
    EXPECT_EQ(std::size_t(std::distance(begin(files), end(files))), all.size());
    for (std::string const& name : all)
        EXPECT_TRUE(std::filesystem::exists(kept(name))) << name;
}

TEST(ReferenceImages, EqualTodaysToTheLastValue)
{
    TexturesRun run(TEXTURES_PROGRAM);
    ASSERT_EQ(run.exit_code("--create_images"), 0) << run.err();
    for (std::string const& name : names())
        EXPECT_TRUE(stored(run.image(name)).getPixels() == stored(kept(name)).getPixels()) << name;
}
