#include <cglib/rt/shading.h>

#include <cglib/rt/scene.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {
glm::vec3 const up(0.f, 1.f, 0.f);

/// A plane y = 0 of k_d 0.18 under a light of power 4 at (0, 2, 0): 1 arrives at the origin.
struct LitPlane {
    LitPlane() : activation(context)
    {
        scene.objects.push_back(create_plane(glm::vec3(0.f), up));
        scene.lights.push_back({glm::vec3(0.f, 2.f, 0.f), glm::vec3(4.f)});
        context.scene = &scene;
    }

    float brightness(Ray const& ray)
    {
        RenderPlan const plan = plan_render(scene, context.params);
        context.plan = &plan;
        ThreadLocalData thread;
        RenderData data(context, thread);
        Intersection isect;
        scene.objects[0]->intersect(ray, &isect);
        scene.objects[0]->compute_shading_info(&isect);
        return phong(data, ray, isect).g;
    }

    Scene scene;
    RaytracingContext context;
    RaytracingContext::Activation activation;
};

Ray const from_above(up, -up);
}  // namespace

TEST(Phong, DiffuseAndAmbientAddUp)
{
    EXPECT_NEAR(LitPlane().brightness(from_above), 0.18f + 0.018f, 1e-6f);
}

TEST(Phong, ShadowLeavesTheAmbientLight)
{
    LitPlane plane;
    plane.scene.objects.push_back(create_sphere(glm::vec3(0.f, 1.5f, 0.f), 0.1f));
    EXPECT_NEAR(plane.brightness(from_above), 0.018f, 1e-6f);
    plane.context.params.shadows = false;
    EXPECT_NEAR(plane.brightness(from_above), 0.198f, 1e-6f);
}

TEST(Phong, WhatLiesBehindTheLightCastsNoShadow)
{
    LitPlane plane;
    plane.scene.objects.push_back(create_sphere(glm::vec3(0.f, 3.f, 0.f), 0.1f));
    EXPECT_NEAR(plane.brightness(from_above), 0.198f, 1e-6f);
}

TEST(Phong, BackSideIsBlack)
{
    EXPECT_EQ(LitPlane().brightness(Ray(-up, up)), 0.f);
}

TEST(Phong, TermsCanBeSwitchedOff)
{
    LitPlane plane;
    plane.context.params.ambient = false;
    EXPECT_NEAR(plane.brightness(from_above), 0.18f, 1e-6f);
    plane.context.params.diffuse = false;
    EXPECT_EQ(plane.brightness(from_above), 0.f);
}

TEST(Phong, HighlightIsInTheMirrorDirection)
{
    LitPlane plane;
    plane.scene.objects[0]->material->k_s = std::make_shared<ConstTexture>(glm::vec3(0.5f));
    plane.scene.objects[0]->material->n = 50.f;
    EXPECT_NEAR(plane.brightness(from_above), 0.198f + 0.5f, 1e-6f);
    EXPECT_NEAR(plane.brightness(Ray(glm::vec3(1.f, 1.f, 0.f), glm::vec3(-1.f, -1.f, 0.f))), 0.198f, 1e-4f);
}

TEST(Fresnel, StraightOnIsTheSquaredRatioOfTheDifference)
{
    EXPECT_NEAR(fresnel(1.f, 1.f / 1.5f), 0.04f, 1e-6f);
    EXPECT_NEAR(fresnel(1.f, 1.5f), 0.04f, 1e-6f);
}

TEST(Fresnel, EverythingIsReflectedAtGrazingAndBeyondTheCriticalAngle)
{
    EXPECT_NEAR(fresnel(0.f, 1.f / 1.5f), 1.f, 1e-6f);
    EXPECT_EQ(fresnel(0.5f, 1.5f), 1.f);
    EXPECT_EQ(fresnel(std::nanf(""), 1.5f), 1.f);
}

TEST(Fresnel, BrewstersAngleReflectsHalfOfThePerpendicularLight)
{
    // tan(angle) = 1.5, where nothing parallel is reflected; the rest is ((1 - 1.5^2) / (1 + 1.5^2))^2.
    float const cosine = 1.f / std::sqrt(1.f + 1.5f * 1.5f);
    EXPECT_NEAR(fresnel(cosine, 1.f / 1.5f), 0.5f * 0.147929f, 1e-5f);
}

namespace {
/// A unit sphere of a material in front of an environment that is as bright as y is high.
struct SphereInTheOpen {
    SphereInTheOpen()
    {
        Image image(4, 64);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 4; ++x)
                image.setPixel(x, y, glm::vec4((float(y) + 0.5f) / 64.f));
        scene.environment = std::make_shared<ImageTexture>(image, BILINEAR, REPEAT);
        scene.objects.push_back(create_sphere(glm::vec3(0.f), 1.f));
        scene.objects[0]->material->k_d = std::make_shared<ConstTexture>(glm::vec3(0.f));
        context.scene = &scene;
    }

    float seen(Ray const& ray)
    {
        RenderPlan const plan = plan_render(scene, context.params);
        context.plan = &plan;
        RaytracingContext::Activation const activation(context);
        ThreadLocalData thread;
        RenderData data(context, thread);
        return trace_camera_ray(data, ray).g;
    }

    Material& material() { return *scene.objects[0]->material; }

    Scene scene;
    RaytracingContext context;
};

std::shared_ptr<Texture> constant(float value)
{
    return std::make_shared<ConstTexture>(glm::vec3(value));
}

/// Hits the sphere at 45 degrees of latitude, and is mirrored straight up.
Ray const to_the_slope(glm::vec3(0.f, std::sqrt(0.5f), 5.f), glm::vec3(0.f, 0.f, -1.f));
}  // namespace

TEST(Environment, IsLookedUpByLongitudeAndLatitude)
{
    SphereInTheOpen open;
    EXPECT_NEAR(open.seen(Ray(glm::vec3(0.f, 5.f, 0.f), glm::vec3(1.f, 0.f, 0.f))), 0.5f, 1e-4f);
    EXPECT_NEAR(open.seen(Ray(glm::vec3(0.f, 5.f, 0.f), glm::vec3(0.f, 1.f, 1.f))), 0.75f, 1e-4f);
    EXPECT_EQ(open.context.stats.environment_lookups, 2u);
}

TEST(Reflection, ShowsWhatTheMirrorSees)
{
    SphereInTheOpen open;
    open.material().k_r = constant(0.5f);
    // A little off the pole, whose texels wrap around.
    EXPECT_NEAR(open.seen(Ray(to_the_slope.origin - glm::vec3(0.f, 0.1f, 0.f), to_the_slope.direction)), 0.45f, 0.02f);
    EXPECT_EQ(open.context.stats.reflected_rays, 1u);
}

TEST(Reflection, EndsAtTheDepthOrWhenItIsOff)
{
    SphereInTheOpen open;
    open.material().k_r = constant(0.5f);
    open.context.params.max_depth = 0;
    EXPECT_EQ(open.seen(to_the_slope), 0.f);
    open.context.params.max_depth = 1;
    open.context.params.reflection = false;
    EXPECT_EQ(open.seen(to_the_slope), 0.f);
    EXPECT_EQ(open.context.stats.reflected_rays, 0u);
}

TEST(Transmission, PassesStraightThroughTheMiddle)
{
    SphereInTheOpen open;
    open.material().k_t = constant(1.f);
    open.material().eta = 1.5f;
    open.context.params.fresnel = false;
    EXPECT_NEAR(open.seen(Ray(glm::vec3(0.f, 0.f, 5.f), glm::vec3(0.f, 0.f, -1.f))), 0.5f, 1e-4f);
    EXPECT_EQ(open.context.stats.transmitted_rays, 2u);
}

TEST(Transmission, TurnsTheWorldUpsideDown)
{
    SphereInTheOpen open;
    open.material().k_t = constant(1.f);
    open.material().eta = 1.5f;
    EXPECT_LT(open.seen(Ray(glm::vec3(0.f, 0.6f, 5.f), glm::vec3(0.f, 0.f, -1.f))), 0.45f);
}

TEST(Transmission, OffLeavesTheSphereBlack)
{
    SphereInTheOpen open;
    open.material().k_t = constant(1.f);
    open.context.params.transmission = false;
    EXPECT_EQ(open.seen(Ray(glm::vec3(0.f, 0.f, 5.f), glm::vec3(0.f, 0.f, -1.f))), 0.f);
}
