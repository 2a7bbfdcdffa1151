// What each picture of the sheet takes: nothing is computed in vain. A changed count is a changed plan, scene or
// texture; `03_textures --create_images --stats` prints the new ones.
#include <cglib/rt/render_stats.h>

#include <cglib/core/build_paths.h>
#include <cglib/rt/assignment_images.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/scenes.h>

#include <gtest/gtest.h>

#include <map>

namespace {
using Counts = std::vector<std::uint64_t>;

/// In the order of --create_images, each scene being made once: camera, corner, shadow, reflected, transmitted rays;
/// object tests; material samples, tangent frames, normal-map lookups, environment lookups; mip levels, textures
/// loaded.
// clang-format off
std::vector<std::pair<std::string, Counts>> const expected = {
    // [counts]
    {"plane_after_a_zero", {65536, 0, 13924, 0, 0, 65280, 65280, 0, 0, 0, 0, 1}},
    {"plane_after_b_clamp", {65536, 0, 65280, 0, 0, 66722, 65280, 0, 0, 0, 0, 0}},
    {"plane_after_b_repeat", {65536, 0, 65280, 0, 0, 66722, 65280, 0, 0, 0, 0, 0}},
    {"plane_after_c", {65536, 0, 65280, 0, 0, 66722, 65280, 0, 0, 0, 0, 0}},
    {"plane_after_d", {65536, 261120, 65280, 0, 0, 66722, 65280, 0, 0, 0, 7, 0}},
    {"plane_after_d_debugmip", {65536, 261120, 65280, 0, 0, 66722, 65280, 0, 0, 0, 0, 0}},
    {"plane_after_d_dudv", {65536, 261120, 0, 0, 0, 65280, 0, 0, 0, 0, 0, 0}},
    {"goboard_after_a_zero", {65536, 0, 139815, 46540, 0, 166083, 46652, 0, 0, 65424, 0, 2}},
    {"goboard_after_c", {65536, 0, 139815, 46540, 0, 166083, 46652, 0, 0, 65424, 0, 0}},
    {"goboard_after_d", {65536, 185608, 139815, 46540, 0, 166083, 46652, 0, 0, 65424, 11, 0}},
    {"goboard_after_d_debugmip", {65536, 185608, 139815, 46540, 0, 166083, 46652, 0, 0, 65424, 0, 0}},
    {"goboard_after_d_dudv", {65536, 186160, 0, 0, 0, 67438, 0, 0, 0, 0, 0, 0}},
    {"goboard_after_e", {65536, 0, 144492, 46654, 0, 185313, 57241, 0, 0, 54949, 0, 0}},
    {"goboard_after_f", {65536, 0, 144561, 46654, 0, 190235, 57455, 36446, 36446, 54735, 0, 1}},
    {"sphere_after_d", {65536, 262144, 128260, 0, 0, 171413, 65536, 0, 0, 0, 19, 2}},
    {"sphere_after_d_debugmip", {65536, 262144, 128260, 0, 0, 171413, 65536, 0, 0, 0, 0, 0}},
    {"sphere_after_d_dudv", {65536, 262144, 0, 0, 0, 102315, 0, 0, 0, 0, 0, 0}},
    {"sphere_after_f", {65536, 0, 125148, 0, 0, 169435, 65536, 65536, 65536, 0, 0, 2}},
    {"pooltable_after_e", {65536, 0, 204433, 19374, 0, 336253, 75346, 0, 0, 9564, 0, 17}},
    // [end]
};
// clang-format on

Counts list(RenderStats const& stats)
{
    Counts counts;
    visit_stats(stats, [&](char const*, std::uint64_t count) { counts.push_back(count); });
    return counts;
}

AssignmentImage const& find(std::string const& name)
{
    for (AssignmentImage const& picture : assignment_images())
        if (picture.name == name)
            return picture;
    throw std::invalid_argument(name);
}
}  // namespace

TEST(RenderStats, EachPictureOfTheSheetTakesWhatItMust)
{
    ASSERT_EQ(expected.size(), assignment_images().size());
    AssetLibrary assets(assets_directory());
    std::map<std::string, std::unique_ptr<Scene>> scenes;
    for (auto const& [name, counts] : expected) {
        AssignmentImage const& picture = find(name);
        auto& scene = scenes[picture.scene];
        if (!scene)
            scene = create_scene(picture.scene, assets);
        Image image;
        EXPECT_EQ(list(render_scene(*scene, picture.params, &image)), counts) << name;
    }
}

TEST(RenderStats, EachTextureIsLoadedOnceForAllPictures)
{
    std::uint64_t loaded = 0;
    for (auto const& [name, counts] : expected)
        loaded += counts.back();
    // Two normal maps and two diffuse maps of the sphere, two of the board, 16 of the table, one of the plane, two
    // environments.
    EXPECT_EQ(loaded, 25u);
}

TEST(RenderStats, NearestOnThePlaneTakesNothingBeyondItsHits)
{
    AssetLibrary assets(assets_directory());
    Image image;
    auto const scene = create_scene("plane", assets);
    RenderStats const stats = render_scene(*scene, find("plane_after_a_zero").params, &image);
    EXPECT_EQ(stats.corner_rays, 0u);
    EXPECT_EQ(stats.mip_levels, 0u);
    EXPECT_EQ(stats.normal_map_lookups, 0u);
    EXPECT_EQ(stats.environment_lookups, 0u);
    EXPECT_EQ(stats.textures_loaded, 1u);
}

TEST(RenderStats, DoNotDependOnTheThreads)
{
    AssetLibrary assets(assets_directory());
    RaytracingParameters params;
    params.width = params.height = 64;
    RenderOptions eight;
    eight.threads = 8;
    Image image;
    Counts const one = list(render_scene(*create_scene("goboard", assets), params, &image));
    EXPECT_EQ(list(render_scene(*create_scene("goboard", assets), params, &image, eight)), one);
}
