#include <cglib/rt/prepared_render.h>

#include <cglib/core/build_paths.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/scenes.h>

#include <gtest/gtest.h>

namespace {
Image with_threads(std::string const& scene, int threads)
{
    AssetLibrary assets(assets_directory());
    RaytracingParameters params;
    params.width = 61;
    params.height = 43;
    params.spp = 3;
    params.tex_filter_mode = TRILINEAR;
    RenderOptions options;
    options.threads = threads;
    Image image;
    render_scene(*create_scene(scene, assets), params, &image, options);
    return image;
}
}  // namespace

TEST(PreparedRender, OneThreadAndEightMakeTheSameBytes)
{
    for (std::string const& scene : scene_names())
        EXPECT_EQ(with_threads(scene, 1).getPixels(), with_threads(scene, 8).getPixels()) << scene;
}

TEST(PreparedRender, TilesAreTheirPartOfThePicture)
{
    AssetLibrary assets(assets_directory());
    auto const scene = create_scene("plane", assets);
    RaytracingParameters params;
    params.width = params.height = 20;
    Image whole;
    render_scene(*scene, params, &whole);
    PreparedRender const prepared(*scene, params);
    Image part(20, 20);
    RenderStats const stats = prepared.render({3, 5, 9, 7}, &part);
    EXPECT_EQ(stats.camera_rays, 12u);
    EXPECT_EQ(part.getPixel(8, 6), whole.getPixel(8, 6));
    EXPECT_EQ(part.getPixel(9, 6), glm::vec4(0.f));
    EXPECT_EQ(part.getPixel(8, 7), glm::vec4(0.f));
}
