// 03_textures: the program that students make out of their exercise_03.cpp.
#include "create_images.h"

#include <cglib/core/build_paths.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

namespace {
int const failed = 2;

int run(int argc, char** argv)
{
    CLI::App app("Exercise 3: texture mapping, aliasing and transformations", "03_textures");
    bool wants_images = false;
    app.add_flag("--create_images,--create-images", wants_images,
                 "Write the pictures of the exercise sheet into ./assignment_images");
    try {
        app.parse(argc, argv);
    } catch (CLI::ParseError const& error) {
        return app.exit(error) == 0 ? 0 : failed;
    }
    if (wants_images)
        create_images(assets_directory(), "assignment_images");
    else
        std::fputs(app.help().c_str(), stdout);
    return 0;
}
}  // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (std::exception const& error) {
        std::fprintf(stderr, "03_textures: %s\n", error.what());
        return failed;
    }
}
