#include "options.h"

#include "choices.h"

#include <cglib/core/build_paths.h>
#include <cglib/rt/scenes.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <thread>

namespace {
int const largest_side = 16384;
int const most_samples = 4096;

template <class Enum>
void add_choice(CLI::App& app, std::string const& name, Enum& value, std::map<std::string, Enum> const& names,
                std::string const& description)
{
    std::string list;
    for (auto const& [key, ignored] : names)
        list += (list.empty() ? "" : ", ") + key;
    auto const choose = [&value, &names](std::string const& wanted) {
        value = names.at(CLI::detail::to_lower(wanted));
    };
    auto const is_known = [&names, list](std::string const& wanted) {
        return names.count(CLI::detail::to_lower(wanted)) > 0 ? std::string() : wanted + " is none of " + list;
    };
    app.add_option_function<std::string>(name, choose, description + ": " + list)->check(is_known)->type_name("NAME");
}

/// A single picture is a PNG: what other writers make of a full disk is not always told.
void check_output(Options const& options, bool is_folder)
{
    if (options.output.empty() || is_folder)
        return;
    if (CLI::detail::to_lower(std::filesystem::path(options.output).extension().string()) != ".png")
        throw CLI::ValidationError("--output", options.output + " does not end in .png");
}

/// The pictures of the sheet have their own numbers.
void exclude_picture_options(CLI::App& app, CLI::Option* images)
{
    for (char const* name : {"--scene", "--filter", "--wrap", "--mode", "--width", "--height", "--spp", "--stratified",
                             "--depth", "--normal_mapping", "--no_transforms"})
        images->excludes(app.get_option(name));
}

void add_picture_options(CLI::App& app, Options& options)
{
    RaytracingParameters& params = options.params;
    app.add_option("--scene", options.scene, "What to render")->check(CLI::IsMember(scene_names()));
    add_choice(app, "--filter", params.tex_filter_mode, filter_choices(), "How textures are filtered");
    add_choice(app, "--wrap", params.tex_wrap_mode, wrap_choices(), "What lies outside a texture");
    add_choice(app, "--mode", params.render_mode, mode_choices(), "What a pixel shows");
    app.add_option("--width", params.width, "In pixels")->check(CLI::Range(1, largest_side));
    app.add_option("--height", params.height, "In pixels")->check(CLI::Range(1, largest_side));
    app.add_option("--spp", params.spp, "Samples in each pixel")->check(CLI::Range(1, most_samples));
    app.add_flag("--stratified", params.stratified, "Spread the samples over a grid");
    app.add_option("--depth", params.max_depth, "How often a ray may be reflected")->check(CLI::Range(0, 64));
    app.add_flag("--normal_mapping,--normal-mapping", params.normal_mapping, "Use normal maps");
    app.add_flag("!--no_transforms,!--no-transforms", params.transform_objects,
                 "Leave objects where they are without their matrices");
}

void add_other_options(CLI::App& app, Options& options)
{
    app.add_option("--assets", options.assets, "Folder of the textures, found by their names without extension");
    app.add_option("--output", options.output,
                   "The picture's file (default: show the viewer), or the folder of --create_images");
    app.add_option("--threads", options.threads, "Default: as many as the machine has")->check(CLI::Range(1, 256));
    app.add_flag("--stats", options.stats, "Say what each picture took");
    app.add_option("--drive", options.drive, "For tests: a file of lines that the viewer obeys like a user's hands");
}
}  // namespace

Options parse_options(int argc, char** argv)
{
    CLI::App app("Exercise 3: texture mapping, aliasing and transformations", "03_textures");
    Options options;
    options.assets = assets_directory();
    options.threads = std::max(1, int(std::thread::hardware_concurrency()));
    bool wants_images = false;
    bool wants_list = false;
    CLI::Option* const images = app.add_flag("--create_images,--create-images", wants_images,
                                             "Write the pictures of the exercise sheet into ./assignment_images");
    app.add_flag("--list", wants_list, "List scenes and pictures");
    add_picture_options(app, options);
    add_other_options(app, options);
    exclude_picture_options(app, images);
    try {
        app.parse(argc, argv);
        check_output(options, wants_images);
    } catch (CLI::ParseError const& error) {
        // Prints help or what is wrong.
        throw CLI::RuntimeError(app.exit(error) == 0 ? 0 : 2);
    }
    options.size_is_given = app.count("--width") + app.count("--height") > 0;
    if (wants_list)
        options.action = Options::Action::list;
    else if (wants_images)
        options.action = Options::Action::create_images;
    else if (!options.output.empty())
        options.action = Options::Action::render;
    return options;
}
