#include <cglib/rt/transform.h>

#include <gtest/gtest.h>

namespace {
glm::mat4 const twice_as_wide =
    glm::scale(glm::translate(glm::mat4(1.f), glm::vec3(1.f, 0.f, 0.f)), glm::vec3(2, 1, 1));

Intersection hit()
{
    Intersection isect;
    isect.position = glm::vec3(1.f, 2.f, 3.f);
    isect.normal = isect.geometric_normal = glm::vec3(0.f, 1.f, 0.f);
    isect.t = 5.f;
    return isect;
}
}  // namespace

TEST(TransformRay, DirectionIsUnitAgain)
{
    Ray const ray = transform_ray(Ray(glm::vec3(1.f), glm::vec3(1.f, 0.f, 0.f)), twice_as_wide);
    EXPECT_EQ(ray.origin, glm::vec3(3.f, 1.f, 1.f));
    EXPECT_EQ(ray.direction, glm::vec3(1.f, 0.f, 0.f));
}

TEST(TransformIntersection, PositionAndNormalsChangeButNotT)
{
    Intersection const isect = transform_intersection(hit(), twice_as_wide, glm::mat4(1.f));
    EXPECT_EQ(isect.position, glm::vec3(3.f, 2.f, 3.f));
    EXPECT_EQ(isect.normal, glm::vec3(0.f, 1.f, 0.f));
    EXPECT_EQ(isect.t, 5.f);
}

TEST(TransformIntersection, VectorsThatAreNotSetStayUnset)
{
    Intersection const isect = transform_intersection(hit(), twice_as_wide, glm::mat4(1.f));
    EXPECT_EQ(isect.tangent, glm::vec3(0.f));
    EXPECT_EQ(isect.shading_normal, glm::vec3(FLT_MAX));
}

TEST(Transform, IsOffWhereObjectsAreNotTransformed)
{
    RaytracingContext context;
    context.params.transform_objects = false;
    RaytracingContext::Activation const activation(context);
    EXPECT_EQ(transform_ray(Ray(glm::vec3(1.f), glm::vec3(1.f, 0.f, 0.f)), twice_as_wide).origin, glm::vec3(1.f));
    EXPECT_EQ(transform_intersection(hit(), twice_as_wide, glm::mat4(1.f)).position, hit().position);
}
