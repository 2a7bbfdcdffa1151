#pragma once

#include <cglib/rt/raytracing_parameters.h>

#include <string>

/// What the command line of 03_textures asks for.
struct Options {
    enum class Action { show_viewer, create_images, render, list };

    Action action = Action::show_viewer;
    std::string scene = "plane";
    RaytracingParameters params;
    /// Width or height were asked for.
    bool size_is_given = false;
    std::string assets;
    /// Of a single picture; the folder of --create_images.
    std::string output;
    int threads = 1;
    bool stats = false;
    /// A file that drives the viewer, see viewer/drive.h. Empty if a person does.
    std::string drive;
};

/// Throws CLI::ParseError for what it does not understand, and for --help.
Options parse_options(int argc, char** argv);
