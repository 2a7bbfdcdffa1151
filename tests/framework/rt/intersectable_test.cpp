#include <cglib/rt/intersectable.h>

#include <gtest/gtest.h>

TEST(Intersectable, NewIntersectionIsInvalid)
{
    EXPECT_FALSE(Intersection().isValid());
    EXPECT_EQ(Intersection().normal, glm::vec3(FLT_MAX));
    EXPECT_EQ(Intersection().uv, glm::vec2(0.f));
}

TEST(Ray, DirectionIsNormalised)
{
    EXPECT_EQ(Ray(glm::vec3(1.f), glm::vec3(0.f, 0.f, 5.f)).direction, glm::vec3(0.f, 0.f, 1.f));
}

TEST(Sphere, HitHasPositionNormalAndDistance)
{
    Intersection isect;
    ASSERT_TRUE(Sphere(glm::vec3(0.f, 1.f, 0.f), 2.f)
                    .intersect(Ray(glm::vec3(0.f, 1.f, 5.f), glm::vec3(0.f, 0.f, -1.f)), &isect));
    EXPECT_EQ(isect.t, 3.f);
    EXPECT_EQ(isect.position, glm::vec3(0.f, 1.f, 2.f));
    EXPECT_EQ(isect.normal, glm::vec3(0.f, 0.f, 1.f));
    EXPECT_EQ(isect.geometric_normal, isect.normal);
}

TEST(Plane, IsHitFromBothSides)
{
    Plane const plane(glm::vec3(0.f), glm::vec3(0.f, 2.f, 0.f));
    for (float y : {3.f, -3.f}) {
        Intersection isect;
        ASSERT_TRUE(plane.intersect(Ray(glm::vec3(1.f, y, 0.f), glm::vec3(0.f, -y, 0.f)), &isect));
        EXPECT_EQ(isect.position, glm::vec3(1.f, 0.f, 0.f));
        EXPECT_EQ(isect.normal, glm::vec3(0.f, 1.f, 0.f));
    }
}

TEST(Plane, HitTooFarAwayForAFloatIsNone)
{
    Intersection isect;
    Ray ray(glm::vec3(0.f, 1e10f, 0.f), glm::vec3(1.f, 0.f, 0.f));
    ray.direction.y = -1e-40f;
    EXPECT_FALSE(Plane(glm::vec3(0.f), glm::vec3(0.f, 1.f, 0.f)).intersect(ray, &isect));
}

TEST(Quad, UvRunFromCornerToCorner)
{
    Quad const quad(glm::vec3(0.f), glm::vec3(4.f, 0.f, 0.f), glm::vec3(0.f, 0.f, -2.f));
    Intersection isect;
    ASSERT_TRUE(quad.intersect(Ray(glm::vec3(1.f, 3.f, 0.5f), glm::vec3(0.f, -1.f, 0.f)), &isect));
    EXPECT_EQ(isect.uv, glm::vec2(0.75f, 0.25f));
    EXPECT_EQ(isect.normal, glm::vec3(0.f, 1.f, 0.f));
}

TEST(Quad, SkewedEdgesAreSolvedFor)
{
    Quad const quad(glm::vec3(0.f), glm::vec3(4.f, 0.f, 0.f), glm::vec3(2.f, 2.f, 0.f));
    Intersection isect;
    glm::vec3 const inside = 0.25f * quad.e0 - 0.5f * quad.e1;
    ASSERT_TRUE(quad.intersect(Ray(inside + glm::vec3(0.f, 0.01f, 1.f), glm::vec3(0.f, 0.f, -1.f)), &isect));
    EXPECT_NEAR(isect.uv.y, 0.005f, 1e-5f);
}

TEST(Quad, OutsideIsNotHit)
{
    Quad const quad(glm::vec3(0.f), glm::vec3(4.f, 0.f, 0.f), glm::vec3(0.f, 0.f, -2.f));
    Intersection isect;
    EXPECT_FALSE(quad.intersect(Ray(glm::vec3(0.f, 3.f, 1.1f), glm::vec3(0.f, -1.f, 0.f)), &isect));
    EXPECT_FALSE(quad.intersect(Ray(glm::vec3(-2.1f, 3.f, 0.f), glm::vec3(0.f, -1.f, 0.f)), &isect));
}
