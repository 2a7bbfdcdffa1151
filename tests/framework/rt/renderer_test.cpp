#include <cglib/rt/renderer.h>

#include "pictures.h"
#include "scene_of_one.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {
Image rendered(Scene& scene, RaytracingParameters const& params)
{
    Image image;
    render_scene(scene, params, &image);
    return image;
}

RaytracingParameters parameters(RenderMode mode, TextureFilterMode filter = NEAREST)
{
    RaytracingParameters params;
    params.width = params.height = 33;
    params.render_mode = mode;
    params.tex_filter_mode = filter;
    return params;
}

glm::vec3 rgb(Image const& image, int x, int y)
{
    return glm::vec3(image.getPixel(x, y));
}

/// The sphere with an image texture.
Scene textured_scene()
{
    Scene scene = scene_of_one_sphere();
    scene.textures.push_back({std::make_shared<ImageTexture>(numbered_image(8, 8), NEAREST, REPEAT), nullptr});
    scene.objects[0]->material->k_d = scene.textures[0].texture;
    return scene;
}
}  // namespace

TEST(Renderer, CameraRayIsThatOfTheFormula)
{
    Scene scene;
    RaytracingContext context;
    context.scene = &scene;
    context.params.width = 100;
    context.params.height = 50;
    Ray const ray = camera_ray(context, glm::vec2(0.5f, 49.5f));
    glm::vec3 const expected = glm::normalize(glm::vec3(0.5f - 50.f, 49.5f - 25.f, -50.f));
    EXPECT_LT(glm::length(ray.direction - expected), 1e-6f);
}

TEST(Renderer, NormalModeShowsNormals)
{
    Scene scene = scene_of_one_sphere();
    Image const image = rendered(scene, parameters(NORMAL));
    EXPECT_LT(glm::length(rgb(image, 16, 16) - glm::vec3(0.5f, 0.5f, 1.f)), 1e-5f);
    EXPECT_GT(rgb(image, 16, 20).g, 0.6f);
    EXPECT_GT(rgb(image, 20, 16).r, 0.6f);
    EXPECT_EQ(rgb(image, 0, 0), glm::vec3(0.f));
}

TEST(Renderer, NothingButSceneIsBlackAndOpaque)
{
    Scene scene;
    EXPECT_EQ(rendered(scene, parameters(RECURSIVE)).getPixel(5, 5), glm::vec4(0.f, 0.f, 0.f, 1.f));
}

TEST(Renderer, DudvModeShowsFootprintsWhereSomethingIsHit)
{
    Scene scene = textured_scene();
    Image const image = rendered(scene, parameters(DUDV, TRILINEAR));
    EXPECT_EQ(rgb(image, 0, 0), glm::vec3(0.f));
    EXPECT_EQ(rgb(image, 16, 16).b, 1.f);
    EXPECT_GT(rgb(image, 16, 16).g, 0.f);
    EXPECT_EQ(rgb(rendered(scene, parameters(DUDV)), 16, 16), glm::vec3(0.f, 0.f, 1.f));
}

TEST(Renderer, FilterAndWrapReachTheTextures)
{
    Scene scene = textured_scene();
    RaytracingParameters params = parameters(RECURSIVE, BILINEAR);
    params.tex_wrap_mode = CLAMP;
    rendered(scene, params);
    EXPECT_EQ(scene.textures[0].texture->filter_mode, BILINEAR);
    EXPECT_EQ(scene.textures[0].texture->wrap_mode, CLAMP);
}

TEST(Renderer, MipLevelsAreMadeOnceAndOnlyWhereRead)
{
    Scene scene = textured_scene();
    for (RaytracingParameters const& params : {parameters(RECURSIVE), parameters(RECURSIVE, BILINEAR),
                                               parameters(DUDV, TRILINEAR), parameters(NORMAL, TRILINEAR)}) {
        rendered(scene, params);
        EXPECT_EQ(scene.textures[0].texture->get_mip_levels().size(), 1u);
    }
    rendered(scene, parameters(RECURSIVE, TRILINEAR));
    std::shared_ptr<Image> const level_1 = scene.textures[0].texture->get_mip_levels().at(1);
    rendered(scene, parameters(RECURSIVE, DEBUG_MIP));
    EXPECT_EQ(scene.textures[0].texture->get_mip_levels().size(), 4u);
    EXPECT_EQ(scene.textures[0].texture->get_mip_levels().at(1), level_1);
}

TEST(Renderer, NearestObjectWins)
{
    Scene scene = scene_of_one_sphere();
    scene.objects.insert(scene.objects.begin(), create_sphere(glm::vec3(0.f, 0.f, -5.f), 3.f));
    RaytracingContext context;
    context.scene = &scene;
    ThreadLocalData thread;
    RenderData data(context, thread);
    Intersection isect;
    EXPECT_EQ(find_nearest_hit(data, Ray(glm::vec3(0.f, 0.f, 4.f), glm::vec3(0.f, 0.f, -1.f)), &isect),
              scene.objects[1].get());
    EXPECT_EQ(isect.t, 3.f);
    EXPECT_EQ(find_nearest_hit(data, Ray(glm::vec3(0.f, 0.f, 4.f), glm::vec3(0.f, 0.f, 1.f)), &isect), nullptr);
    EXPECT_EQ(data.num_rays, 2);
}

TEST(Renderer, HeatmapModesStayOnTheScale)
{
    Scene scene = textured_scene();
    scene.lights.push_back({glm::vec3(0.f, 0.f, 10.f), glm::vec3(100.f)});
    EXPECT_GT(rgb(rendered(scene, parameters(NUM_RAYS)), 16, 16).g, rgb(rendered(scene, parameters(NUM_RAYS)), 0, 0).g);
    EXPECT_LE(rgb(rendered(scene, parameters(TIME)), 16, 16).r, 1.f);
    glm::vec3 const grey = rgb(rendered(scene, parameters(DESATURATE)), 16, 16);
    EXPECT_EQ(grey.r, grey.b);
    EXPECT_GT(grey.r, 0.f);
}

TEST(Renderer, MoreSamplesSoftenTheSilhouette)
{
    Scene scene = scene_of_one_sphere();
    RaytracingParameters params = parameters(NORMAL);
    params.spp = 16;
    params.stratified = true;
    Image const image = rendered(scene, params);
    EXPECT_EQ(image.getPixels(), rendered(scene, params).getPixels());
    EXPECT_NE(image.getPixels(), rendered(scene, parameters(NORMAL)).getPixels());
}

TEST(Renderer, ContextOfTheCallerIsActiveAgain)
{
    Scene scene;
    RaytracingContext context;
    RaytracingContext::Activation const activation(context);
    rendered(scene, parameters(NORMAL));
    EXPECT_EQ(RaytracingContext::get_active(), &context);
}

TEST(Renderer, TextureIsLoadedWhenItIsFirstNeeded)
{
    Scene scene = scene_of_one_sphere();
    int loads = 0;
    auto const texture = std::make_shared<ImageTexture>(NEAREST, REPEAT);
    scene.objects[0]->material->k_d = texture;
    scene.textures.push_back({texture, [&loads] {
                                  ++loads;
                                  return std::make_shared<Image>(numbered_image(4, 4));
                              }});
    Image image;
    EXPECT_EQ(render_scene(scene, parameters(DUDV, TRILINEAR), &image).textures_loaded, 0u);
    EXPECT_EQ(loads, 0);
    EXPECT_EQ(render_scene(scene, parameters(RECURSIVE), &image).textures_loaded, 1u);
    EXPECT_EQ(render_scene(scene, parameters(RECURSIVE), &image).textures_loaded, 0u);
    EXPECT_EQ(loads, 1);
}
