#include <cglib/rt/assignment_images.h>

#include <cglib/core/assert.h>

#include <fmt/format.h>

namespace {
AssignmentImage picture(char const* name, char const* scene, TextureFilterMode filter, TextureWrapMode wrap,
                        RenderMode mode = RECURSIVE)
{
    AssignmentImage image{name, scene, RaytracingParameters()};
    image.params.max_depth = 1;
    image.params.transform_objects = false;
    image.params.tex_filter_mode = filter;
    image.params.tex_wrap_mode = wrap;
    image.params.render_mode = mode;
    return image;
}

/// With objects where their matrices put them, for tasks e and f.
AssignmentImage transformed(char const* name, char const* scene, bool normal_mapping)
{
    AssignmentImage image = picture(name, scene, NEAREST, REPEAT);
    image.params.transform_objects = true;
    image.params.normal_mapping = normal_mapping;
    return image;
}
}  // namespace

std::vector<AssignmentImage> const& assignment_images()
{
    static std::vector<AssignmentImage> const images = {
        picture("plane_after_a_zero", "plane", NEAREST, ZERO),
        picture("goboard_after_a_zero", "goboard", NEAREST, ZERO),
        picture("plane_after_b_clamp", "plane", NEAREST, CLAMP),
        picture("plane_after_b_repeat", "plane", NEAREST, REPEAT),
        picture("plane_after_c", "plane", BILINEAR, REPEAT),
        picture("goboard_after_c", "goboard", BILINEAR, REPEAT),
        picture("plane_after_d", "plane", TRILINEAR, REPEAT),
        picture("plane_after_d_debugmip", "plane", DEBUG_MIP, REPEAT),
        picture("plane_after_d_dudv", "plane", TRILINEAR, REPEAT, DUDV),
        picture("goboard_after_d", "goboard", TRILINEAR, REPEAT),
        picture("goboard_after_d_debugmip", "goboard", DEBUG_MIP, REPEAT),
        picture("goboard_after_d_dudv", "goboard", TRILINEAR, REPEAT, DUDV),
        picture("sphere_after_d", "sphere", TRILINEAR, REPEAT),
        picture("sphere_after_d_debugmip", "sphere", DEBUG_MIP, REPEAT),
        picture("sphere_after_d_dudv", "sphere", TRILINEAR, REPEAT, DUDV),
        transformed("goboard_after_e", "goboard", false),
        transformed("pooltable_after_e", "pooltable", false),
        transformed("goboard_after_f", "goboard", true),
        transformed("sphere_after_f", "sphere", true),
    };
    return images;
}

std::string miplevel_image_name(int level)
{
    cg_assert(level >= 0 && level < num_miplevel_images);
    return fmt::format("miplevel{:02}", level);
}
