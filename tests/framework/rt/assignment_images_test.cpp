#include <cglib/rt/assignment_images.h>

#include <cglib/rt/scenes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

TEST(AssignmentImages, PlaneHasSevenInTheOrderOfTheSheet)
{
    std::vector<std::string> names;
    for (AssignmentImage const& image : assignment_images())
        if (image.scene == "plane")
            names.push_back(image.name);
    EXPECT_EQ(names, (std::vector<std::string>{"plane_after_a_zero", "plane_after_b_clamp", "plane_after_b_repeat",
                                               "plane_after_c", "plane_after_d", "plane_after_d_debugmip",
                                               "plane_after_d_dudv"}));
}

TEST(AssignmentImages, AllAreSmallAndShallow)
{
    for (AssignmentImage const& image : assignment_images()) {
        EXPECT_EQ(image.params.width, 256) << image.name;
        EXPECT_EQ(image.params.height, 256) << image.name;
        EXPECT_EQ(image.params.spp, 1) << image.name;
        EXPECT_EQ(image.params.max_depth, 1) << image.name;
    }
}

TEST(AssignmentImages, NamesDifferAndScenesExist)
{
    std::set<std::string> names;
    std::vector<std::string> const scenes = scene_names();
    for (AssignmentImage const& image : assignment_images()) {
        EXPECT_TRUE(names.insert(image.name).second) << image.name;
        EXPECT_NE(std::find(scenes.begin(), scenes.end(), image.scene), scenes.end()) << image.name;
    }
}

TEST(AssignmentImages, MipLevelsAreNumberedWithTwoDigits)
{
    EXPECT_EQ(miplevel_image_name(0), "miplevel00");
    EXPECT_EQ(miplevel_image_name(7), "miplevel07");
}
