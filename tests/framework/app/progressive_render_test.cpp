#include <viewer/progressive_render.h>

#include "scene_of_one.h"

#include <cglib/rt/renderer.h>

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>

namespace {
using viewer::PictureProgress;
using viewer::ProgressiveRender;

RaytracingParameters parameters(int width, int height, int spp = 1)
{
    RaytracingParameters params;
    params.width = width;
    params.height = height;
    params.spp = spp;
    params.tex_filter_mode = TRILINEAR;
    return params;
}

/// A sphere with a texture that is loaded, and has mip levels made, when the render is prepared.
std::shared_ptr<Scene> textured_scene()
{
    auto scene = std::make_shared<Scene>(scene_of_one_sphere());
    auto texture = std::make_shared<ImageTexture>(TRILINEAR, REPEAT);
    scene->objects[0]->material->k_d = texture;
    scene->textures.push_back({texture, [] {
                                   auto image = std::make_shared<Image>(16, 16);
                                   image->clear(glm::vec4(0.2f));
                                   for (int i = 0; i < 16; ++i)
                                       image->setPixel(i, i, glm::vec4(1.f));
                                   return image;
                               }});
    scene->lights.push_back({glm::vec3(3.f, 4.f, 5.f), glm::vec3(100.f)});
    return scene;
}

/// A person in front of a screen.
struct Onlooker {
    explicit Onlooker(ProgressiveRender& watched) : render(watched) {}

    PictureProgress look() { return render.take_changes(&picture).progress; }

    PictureProgress wait()
    {
        PictureProgress progress = look();
        for (; !progress.finished; progress = look())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return progress;
    }

    ProgressiveRender& render;
    Image picture;
};

RenderStats offline(RaytracingParameters const& params, Camera const& camera, Image* image)
{
    std::shared_ptr<Scene> const scene = textured_scene();
    scene->camera = camera;
    return render_scene(*scene, params, image);
}

void expect_equal(RenderStats const& actual, RenderStats const& expected)
{
    std::vector<std::uint64_t> counts;
    visit_stats(actual, [&](char const*, std::uint64_t count) { counts.push_back(count); });
    auto next = counts.begin();
    visit_stats(expected, [&](char const* what, std::uint64_t count) { EXPECT_EQ(*next++, count) << what; });
}

void nothing() {}
}  // namespace

TEST(ProgressiveRender, EndsWithPictureAndStatsOfRenderScene)
{
    for (int const threads : {1, 3})
        for (int const spp : {1, 5}) {
            ProgressiveRender render(threads, nothing);
            Onlooker onlooker(render);
            std::shared_ptr<Scene> const scene = textured_scene();
            RaytracingParameters const params = parameters(77, 45, spp);
            render.restart({scene, scene->camera, params});
            PictureProgress const progress = onlooker.wait();
            Image expected;
            expect_equal(progress.stats, offline(params, scene_of_one_sphere().camera, &expected));
            EXPECT_TRUE(onlooker.picture.getPixels() == expected.getPixels());
            EXPECT_EQ(progress.error, "");
            EXPECT_EQ(progress.fraction, 1.f);
        }
}

TEST(ProgressiveRender, LastOfManyRestartsWins)
{
    ProgressiveRender render(3, nothing);
    Onlooker onlooker(render);
    std::shared_ptr<Scene> const scene = textured_scene();
    RaytracingParameters params;
    Camera camera;
    for (int i = 0; i < 200; ++i) {
        params = parameters(40 + i % 3, 30, 1 + i % 4);
        params.tex_wrap_mode = TextureWrapMode(i % TEXTURE_WRAP_MODE_COUNT);
        camera = Camera::looking_at(glm::vec3(0.01f * float(i), 0.f, 4.f), glm::vec3(0.f));
        render.restart({scene, camera, params});
        onlooker.look();
        if (i % 10 == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(i % 7));
    }
    Image expected;
    RenderStats const stats = offline(params, camera, &expected);
    EXPECT_EQ(onlooker.wait().stats.camera_rays, stats.camera_rays);
    EXPECT_TRUE(onlooker.picture.getPixels() == expected.getPixels());
}

TEST(ProgressiveRender, FirstImpressionIsCoarse)
{
    ProgressiveRender render(2, nothing);
    Onlooker onlooker(render);
    std::shared_ptr<Scene> const scene = textured_scene();
    render.restart({scene, scene->camera, parameters(64, 64, 4000)});
    while (onlooker.picture.getWidth() == 0)
        onlooker.look();
    EXPECT_EQ(onlooker.picture.getPixel(0, 0), onlooker.picture.getPixel(7, 7));
    EXPECT_GT(glm::length(glm::vec3(onlooker.picture.getPixel(36, 36))), 0.f);
}

TEST(ProgressiveRender, DestructionDoesNotWaitForThePicture)
{
    auto const begin = std::chrono::steady_clock::now();
    {
        ProgressiveRender render(2, nothing);
        std::shared_ptr<Scene> const scene = textured_scene();
        render.restart({scene, scene->camera, parameters(2000, 2000, 4000)});
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(ProgressiveRender, ExceptionIsAMessageAndTheNextPictureIsMade)
{
    ProgressiveRender render(2, nothing);
    Onlooker onlooker(render);
    std::shared_ptr<Scene> const broken = textured_scene();
    broken->textures[0].load = []() -> std::shared_ptr<Image> { throw std::runtime_error("there is no wood"); };
    render.restart({broken, broken->camera, parameters(20, 20)});
    EXPECT_EQ(onlooker.wait().error, "there is no wood");
    std::shared_ptr<Scene> const scene = textured_scene();
    render.restart({scene, scene->camera, parameters(20, 20)});
    EXPECT_EQ(onlooker.wait().error, "");
    EXPECT_EQ(onlooker.picture.getWidth(), 20);
}

namespace {
/// Throws for rays to its right half, as code under development may.
struct FaultyObject : Object {
    using Object::Object;
    bool intersect(Ray const& ray, Intersection*) const override
    {
        if (ray.direction.x > 0.f)
            throw std::logic_error("not done yet");
        return false;
    }
};
}  // namespace

TEST(ProgressiveRender, ExceptionOfATileIsAMessage)
{
    ProgressiveRender render(3, nothing);
    Onlooker onlooker(render);
    std::shared_ptr<Scene> const scene = textured_scene();
    scene->objects[0] = std::make_shared<FaultyObject>(scene->objects[0]->geo, scene->objects[0]->texture_mapping);
    render.restart({scene, scene->camera, parameters(64, 64)});
    EXPECT_EQ(onlooker.wait().error, "not done yet");
}

TEST(ProgressiveRender, TellsOfFirstImpressionAndEnd)
{
    std::atomic<int> told{0};
    ProgressiveRender render(2, [&] { ++told; });
    Onlooker onlooker(render);
    std::shared_ptr<Scene> const scene = textured_scene();
    render.restart({scene, scene->camera, parameters(50, 50)});
    onlooker.wait();
    while (told < 2)
        std::this_thread::yield();
    EXPECT_EQ(told, 2);
}
