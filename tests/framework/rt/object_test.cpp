#include <cglib/rt/object.h>

#include <cglib/rt/render_plan.h>
#include <cglib/rt/texture.h>

#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {
glm::vec3 const up(0.f, 1.f, 0.f);

/// Puts uv = (x, y) wherever it is asked.
class PositionMapping : public TextureMapping {
public:
    glm::vec2 get_uv(Intersection const& isect) const override { return glm::vec2(isect.position); }
};

/// Makes uv, footprint and tangent space part of a hit whatever the material is.
struct Everything {
    Everything()
    {
        plan.footprints_shown = true;
        plan.normal_maps = true;
        context.plan = &plan;
    }
    RenderPlan plan;
    RaytracingContext context;
    RaytracingContext::Activation activation{context};
};

/// Bends the normal to the tangent.
std::shared_ptr<Texture> bent_normal()
{
    return std::make_shared<ConstTexture>(glm::vec3(1.f, 0.5f, 0.f));
}

Object mapped_by_position()
{
    return Object(std::make_shared<Plane>(glm::vec3(0.f), up), std::make_shared<PositionMapping>());
}

/// The u that get_intersection_uvs gives for the u of four positions, around center.
std::vector<float> mended(float center, std::vector<float> const& u)
{
    glm::vec3 const positions[4] = {{u[0], 0, 0}, {u[1], 0, 0}, {u[2], 0, 0}, {u[3], 0, 0}};
    Intersection isect;
    isect.uv = glm::vec2(center, 0.f);
    glm::vec2 uvs[4];
    mapped_by_position().get_intersection_uvs(positions, isect, uvs);
    return {uvs[0].x, uvs[1].x, uvs[2].x, uvs[3].x};
}
}  // namespace

TEST(GetIntersectionUvs, OppositeDifferencesStayAsTheyAre)
{
    EXPECT_EQ(mended(0.5f, {0.4f, 0.7f, 0.9f, 0.1f}), (std::vector<float>{0.4f, 0.7f, 0.9f, 0.1f}));
}

TEST(GetIntersectionUvs, LongerOfTwoEqualDirectionsIsMirrored)
{
    EXPECT_EQ(mended(0.125f, {0.25f, 1.f, 0.f, 0.5f}), (std::vector<float>{0.25f, 0.f, 0.f, 0.5f}));
    EXPECT_EQ(mended(0.875f, {0.f, 0.75f, 0.75f, 0.5f}), (std::vector<float>{1.f, 0.75f, 0.75f, 1.f}));
}

TEST(GetIntersectionUvs, PointAtTheCentreIsNoSeam)
{
    EXPECT_EQ(mended(0.5f, {0.5f, 0.9f, 0.5f, 0.5f}), (std::vector<float>{0.5f, 0.9f, 0.5f, 0.5f}));
}

TEST(Object, MatricesFollowTheTransform)
{
    std::unique_ptr<Object> const sphere = create_sphere(glm::vec3(0.f), 1.f);
    glm::mat4 const transform =
        glm::scale(glm::translate(glm::mat4(1.f), glm::vec3(3.f, 0.f, 0.f)), glm::vec3(1, 2, 4));
    sphere->set_transform_object_to_world(transform);
    EXPECT_EQ(sphere->transform_object_to_world, transform);
    EXPECT_EQ(sphere->transform_world_to_object * glm::vec4(3.f, 2.f, 4.f, 1.f), glm::vec4(0.f, 1.f, 1.f, 1.f));
    EXPECT_EQ(sphere->transform_object_to_world_normal * glm::vec4(1.f, 2.f, 4.f, 0.f), glm::vec4(1.f, 1.f, 1.f, 0.f));
    EXPECT_EQ(sphere->transform_world_to_object_normal * glm::vec4(1.f, 1.f, 1.f, 0.f), glm::vec4(1.f, 2.f, 4.f, 0.f));
}

TEST(Object, PlaneUvFollowTangentAndBitangent)
{
    auto const plane = create_plane(glm::vec3(-5.f, 0.f, 5.f), up, glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), 10.f);
    plane->material->normal = bent_normal();
    Everything const everything;
    Intersection isect;
    ASSERT_TRUE(plane->intersect(Ray(glm::vec3(0.f, 1.f, 2.5f), -up), &isect));
    plane->compute_shading_info(&isect);
    EXPECT_EQ(isect.uv, glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(isect.tangent, glm::vec3(1.f, 0.f, 0.f));
    EXPECT_EQ(isect.bitangent, glm::vec3(0.f, 0.f, -1.f));
    EXPECT_EQ(isect.shading_normal, glm::vec3(1.f, 0.f, 0.f));
    EXPECT_EQ(isect.dudv, glm::vec2(0.f));
    EXPECT_EQ(isect.material.k_d, glm::vec3(0.18f));
}

TEST(Object, QuadIsFilledOnceWhenScaledByTheSquaredEdge)
{
    auto const quad = create_quad(glm::vec3(0.f), up, glm::vec3(0, 0, 100), glm::vec3(100, 0, 0), 10000.f);
    Everything const everything;
    Intersection isect;
    ASSERT_TRUE(quad->intersect(Ray(glm::vec3(-25.f, 1.f, 49.f), -up), &isect));
    quad->compute_shading_info(&isect);
    EXPECT_LT(glm::length(isect.uv - glm::vec2(0.99f, 0.25f)), 1e-6f);
}

TEST(Object, FootprintOfAPlaneIsThatOfThePixel)
{
    auto const plane = create_plane(glm::vec3(0.f), up, glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), 2.f);
    Everything const everything;
    glm::vec3 const eye(0.f, 1.f, 0.f);
    Ray const rays[4] = {Ray(eye, glm::vec3(-1, -1, 2)), Ray(eye, glm::vec3(1, -1, -2)),
                         Ray(eye, glm::vec3(-1, -1, -2)), Ray(eye, glm::vec3(1, -1, 2))};
    Intersection isect;
    ASSERT_TRUE(plane->intersect(Ray(eye, -up), &isect));
    plane->compute_shading_info(rays, &isect);
    EXPECT_LT(glm::length(isect.dudv - glm::vec2(1.f, 2.f)), 1e-5f);
}

TEST(Object, ShadingInfoOfATransformedSphereIsInWorldSpace)
{
    auto const sphere = create_sphere(glm::vec3(0.f), 1.f);
    sphere->set_transform_object_to_world(glm::translate(glm::mat4(1.f), glm::vec3(10.f, 0.f, 0.f)));
    sphere->material->normal = bent_normal();
    Everything const everything;
    Intersection isect;
    ASSERT_TRUE(sphere->intersect(Ray(glm::vec3(10.f, 0.f, 5.f), glm::vec3(0.f, 0.f, -1.f)), &isect));
    sphere->compute_shading_info(&isect);
    EXPECT_LT(glm::length(isect.position - glm::vec3(10.f, 0.f, 1.f)), 1e-5f);
    EXPECT_LT(glm::length(isect.tangent - glm::vec3(1.f, 0.f, 0.f)), 1e-5f);
    EXPECT_LT(glm::length(isect.uv - glm::vec2(0.75f, 0.5f)), 1e-5f);
}

TEST(Object, OnlyWhatIsPlannedIsComputed)
{
    auto const plane = create_plane(glm::vec3(0.f), up);
    RaytracingContext context;
    RaytracingContext::Activation const activation(context);
    Intersection isect;
    ASSERT_TRUE(plane->intersect(Ray(glm::vec3(1.f, 1.f, 2.f), -up), &isect));
    plane->compute_shading_info(&isect);
    EXPECT_EQ(isect.tangent, glm::vec3(0.f));
    EXPECT_EQ(isect.uv, glm::vec2(0.f));
    EXPECT_EQ(context.stats.tangent_frames, 0u);
    EXPECT_EQ(context.stats.material_samples, 1u);

    plane->material->k_d = std::make_shared<ImageTexture>(numbered_image(2, 2), NEAREST, REPEAT);
    plane->compute_shading_info(&isect);
    EXPECT_NE(isect.uv, glm::vec2(0.f));
}

TEST(Object, NormalMapTurnsTheShadingNormalOnlyWhenOn)
{
    auto const plane = create_plane(glm::vec3(0.f), up, glm::vec3(1, 0, 0), glm::vec3(0, 0, -1));
    plane->material->normal = bent_normal();
    for (bool on : {false, true}) {
        RenderPlan plan;
        plan.normal_maps = on;
        RaytracingContext context;
        context.plan = &plan;
        RaytracingContext::Activation const activation(context);
        Intersection isect;
        ASSERT_TRUE(plane->intersect(Ray(up, -up), &isect));
        plane->compute_shading_info(&isect);
        EXPECT_EQ(isect.shading_normal, on ? glm::vec3(1.f, 0.f, 0.f) : up);
    }
}
