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
}  // namespace

std::vector<AssignmentImage> const& assignment_images()
{
    static std::vector<AssignmentImage> const images = {
        picture("plane_after_a_zero", "plane", NEAREST, ZERO),
        picture("plane_after_b_clamp", "plane", NEAREST, CLAMP),
        picture("plane_after_b_repeat", "plane", NEAREST, REPEAT),
        picture("plane_after_c", "plane", BILINEAR, REPEAT),
        picture("plane_after_d", "plane", TRILINEAR, REPEAT),
        picture("plane_after_d_debugmip", "plane", DEBUG_MIP, REPEAT),
        picture("plane_after_d_dudv", "plane", TRILINEAR, REPEAT, DUDV),
    };
    return images;
}

std::string miplevel_image_name(int level)
{
    cg_assert(level >= 0 && level < num_miplevel_images);
    return fmt::format("miplevel{:02}", level);
}
