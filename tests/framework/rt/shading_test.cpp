#include <cglib/rt/phong.h>

#include <cglib/rt/scene.h>

#include <gtest/gtest.h>

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
