#pragma once

#include <cglib/rt/raytracing_parameters.h>

#include <string>
#include <vector>

/// One picture of the exercise sheet.
struct AssignmentImage {
    /// Without extension, for example "plane_after_a_zero".
    std::string name;
    /// For create_scene.
    std::string scene;
    /// 256 x 256 pixels, one sample, max_depth 1.
    RaytracingParameters params;
};

/// All rendered pictures, in the order of the sheet.
std::vector<AssignmentImage> const& assignment_images();

/// How many levels of `checker` are written beside them, miplevel00 being the texture itself.
int const num_miplevel_images = 8;

/// "miplevel00" ...; 0 <= level < num_miplevel_images.
std::string miplevel_image_name(int level);
