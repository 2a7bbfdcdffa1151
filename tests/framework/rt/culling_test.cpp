#include "culling.h"

#include "pictures.h"

#include <cglib/rt/renderer.h>
#include <cglib/rt/scenes.h>

#include <cglib/core/build_paths.h>

#include <gtest/gtest.h>

#include <random>

namespace {
/// Numbers of one iteration of a property test.
class Draws {
public:
    explicit Draws(unsigned seed) : generator_(seed) {}
    float between(float lo, float hi) { return std::uniform_real_distribution<float>(lo, hi)(generator_); }
    glm::vec3 vector(float extent)
    {
        float const x = between(-extent, extent);
        float const y = between(-extent, extent);
        return glm::vec3(x, y, between(-extent, extent));
    }
    glm::vec3 direction() { return glm::normalize(vector(1.f) + glm::vec3(1e-3f)); }
    bool coin() { return between(0.f, 1.f) < 0.5f; }

private:
    std::mt19937 generator_;
};

std::shared_ptr<Object> random_object(Draws& draws)
{
    std::shared_ptr<Object> object;
    glm::vec3 const center = draws.vector(2.f);
    float const kind = draws.between(0.f, 3.f);
    if (kind < 1.f)
        object = create_sphere(draws.coin() ? center : center * 3000.f, draws.between(0.01f, 3.f));
    else if (kind < 2.f)
        object = create_quad(center, draws.direction(), draws.direction() * 2.f, draws.direction() * 3.f);
    else
        object = create_plane(center, draws.direction());
    if (draws.coin()) {
        glm::mat4 const moved =
            glm::rotate(glm::translate(glm::mat4(1.f), draws.vector(30.f)), draws.between(0.f, 6.f), draws.direction());
        glm::vec3 const size = glm::exp2(draws.vector(3.f));
        object->set_transform_object_to_world(glm::scale(moved, draws.coin() ? size : -size));
    }
    return object;
}

Scene random_scene(Draws& draws)
{
    Scene scene;
    for (int i = int(draws.between(1.f, 40.f)); i > 0; --i)
        scene.objects.push_back(random_object(draws));
    return scene;
}

/// From anywhere between near and very far, towards something that just may be met.
Ray random_ray(Draws& draws, Scene const& scene)
{
    glm::vec3 const origin = draws.vector(std::exp2(draws.between(0.f, 12.f)));
    auto const index = std::size_t(draws.between(0.f, float(scene.objects.size()) - 0.01f));
    glm::vec3 const target = glm::vec3(scene.objects[index]->transform_object_to_world[3]) + draws.vector(4.f);
    if (draws.between(0.f, 1.f) < 0.1f)  // along an axis
        return Ray(origin, glm::vec3(0.f, draws.coin() ? 1.f : -1.f, 0.f));
    return Ray(origin, target - origin + glm::vec3(1e-4f));
}

void expect_same_hit(Scene& scene, Culling const& culling, Ray const& ray)
{
    RaytracingContext context;
    context.scene = &scene;
    ThreadLocalData thread;
    RenderData data(context, thread);
    Intersection all;
    Object* const expected = find_nearest_hit(data, ray, &all);
    context.culling = &culling;
    Intersection few;
    EXPECT_EQ(find_nearest_hit(data, ray, &few), expected);
    EXPECT_EQ(few.t, all.t);
    EXPECT_EQ(few.position, all.position);

    glm::vec3 const to = ray.origin + 50.f * ray.direction;
    bool const visible = is_visible(data, ray.origin, to);
    context.culling = nullptr;
    EXPECT_EQ(is_visible(data, ray.origin, to), visible);
}

Image rendered(std::string const& scene, RaytracingParameters const& params, RenderOptions const& options)
{
    AssetLibrary assets(assets_directory());
    Image image;
    render_scene(*create_scene(scene, assets), params, &image, options);
    return image;
}
}  // namespace

TEST(Culling, HidesNoHitFromAnyRay)
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        Draws draws(seed);
        Scene scene = random_scene(draws);
        Culling const culling(scene.objects, true);
        for (int i = 0; i < 200; ++i)
            expect_same_hit(scene, culling, random_ray(draws, scene));
        if (HasFailure())
            return;
    }
}

TEST(Culling, PicturesStayTheSameBitForBit)
{
    RenderOptions all;
    all.culling = false;
    for (std::string const& scene : scene_names())
        for (bool const transformed : {false, true}) {
            RaytracingParameters params;
            params.width = params.height = 48;
            params.transform_objects = transformed;
            params.normal_mapping = transformed;
            params.tex_filter_mode = BILINEAR;
            EXPECT_EQ(rendered(scene, params, RenderOptions()).getPixels(), rendered(scene, params, all).getPixels())
                << scene << transformed;
        }
}

TEST(Culling, LeavesOutNearlyEverythingOnTheGoBoard)
{
    AssetLibrary assets(assets_directory());
    auto const scene = create_scene("goboard", assets);
    RaytracingParameters params;
    params.width = params.height = 64;
    Image image;
    RenderStats const stats = render_scene(*scene, params, &image);
    std::uint64_t const rays = stats.camera_rays + stats.shadow_rays + stats.reflected_rays;
    EXPECT_LT(stats.object_tests, 3 * rays);
}

TEST(Culling, RayLeavingAPlaneDoesNotMeetIt)
{
    Scene scene;
    scene.objects.push_back(create_plane(glm::vec3(0.f), glm::vec3(0.f, 1.f, 0.f)));
    Culling const culling(scene.objects, true);
    int met = 0;
    auto const count = [&met](int) { return ++met, FLT_MAX; };
    culling.visit(Ray(glm::vec3(0.f, 0.1f, 0.f), glm::vec3(1.f, 1.f, 0.f)), 100.f, count);
    culling.visit(Ray(glm::vec3(0.f, 5.f, 0.f), glm::vec3(1.f, -1.f, 0.f)), 2.f, count);
    EXPECT_EQ(met, 0);
    culling.visit(Ray(glm::vec3(0.f, 5.f, 0.f), glm::vec3(1.f, -1.f, 0.f)), 100.f, count);
    culling.visit(Ray(glm::vec3(0.f), glm::vec3(1.f, 1.f, 0.f)), 100.f, count);
    EXPECT_EQ(met, 2);
}
