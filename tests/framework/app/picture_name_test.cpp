#include <viewer/picture_name.h>

#include "temporary_directory.h"

#include <gtest/gtest.h>

#include <fstream>

TEST(PictureName, NeverThatOfAFile)
{
    TemporaryDirectory const directory;
    std::string const stem = directory.path("sphere_nearest_normal");
    for (char const* ending : {".png", "-2.png", "-3.png"}) {
        std::string const name = viewer::free_picture_name(stem);
        EXPECT_EQ(name, stem + ending);
        std::ofstream(name) << "a picture";
    }
}
