// 03_textures: the program that students make out of their exercise_03.cpp.
#include "create_images.h"
#include "options.h"
#include "viewer.h"

#include <cglib/rt/assignment_images.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/scenes.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <stdexcept>

namespace {
int const failed = 2;
float const picture_gamma = 2.2f;

void print_stats(std::string const& name, RenderStats const& stats)
{
    fmt::print("{}\n", name);
    visit_stats(stats, [](char const* what, std::uint64_t count) { fmt::print("  {:<20}{:>12}\n", what, count); });
}

void render(Options const& options)
{
    AssetLibrary assets(options.assets);
    Image image;
    RenderOptions how;
    how.threads = options.threads;
    RenderStats const stats = render_scene(*create_scene(options.scene, assets), options.params, &image, how);
    image.save(options.output, picture_gamma);
    if (options.stats)
        print_stats(options.scene, stats);
}

void create_all(Options const& options)
{
    AssetLibrary assets(options.assets);
    create_images(assets, options.output.empty() ? "assignment_images" : options.output, options.threads,
                  [&](std::string const& name, RenderStats const& stats) {
                      if (options.stats)
                          print_stats(name, stats);
                  });
}

void list()
{
    fmt::print("scenes\n");
    for (std::string const& scene : scene_names())
        fmt::print("  {}\n", scene);
    fmt::print("pictures of --create_images\n");
    for (AssignmentImage const& picture : assignment_images())
        fmt::print("  {}\n", picture.name);
    for (int level = 0; level < num_miplevel_images; ++level)
        fmt::print("  {}\n", miplevel_image_name(level));
}

int run(Options const& options)
{
    switch (options.action) {
        case Options::Action::list:
            list();
            return 0;
        case Options::Action::create_images:
            create_all(options);
            return 0;
        case Options::Action::render:
            render(options);
            return 0;
        default:
            return show_viewer(options);
    }
}
}  // namespace

int main(int argc, char** argv)
{
    try {
        int const code = run(parse_options(argc, argv));
        if (std::fflush(stdout) != 0)
            throw std::runtime_error("what was to be printed could not be written");
        return code;
    } catch (CLI::RuntimeError const& end) {
        return end.get_exit_code();
    } catch (std::exception const& error) {
        std::fprintf(stderr, "03_textures: %s\n", error.what());
        return failed;
    }
}
