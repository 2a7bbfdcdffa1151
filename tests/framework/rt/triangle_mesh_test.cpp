#include <cglib/rt/triangle_mesh.h>

#include <cglib/rt/object.h>

#include <gtest/gtest.h>

namespace {
/// A right-angled triangle in the plane z = 0, with uv of its own at each corner.
std::shared_ptr<TriangleMesh> triangle()
{
    std::vector<TriangleMesh::Vertex> const corners = {
        {glm::vec3(0.f, 0.f, 0.f), glm::vec2(0.25f, 0.f)},
        {glm::vec3(4.f, 0.f, 0.f), glm::vec2(1.25f, 0.f)},
        {glm::vec3(0.f, 2.f, 0.f), glm::vec2(0.25f, 1.f)},
    };
    return std::make_shared<TriangleMesh>(corners, std::vector<TriangleMesh::Triangle>{{0, 1, 2}});
}

glm::vec3 const away(0.f, 0.f, -1.f);
}  // namespace

TEST(TriangleMesh, BarycentricCoordinatesAreSharesOfTheArea)
{
    auto const mesh = triangle();
    EXPECT_EQ(mesh->barycentric(0, glm::vec3(0.f)), glm::vec3(1.f, 0.f, 0.f));
    EXPECT_EQ(mesh->barycentric(0, glm::vec3(4.f, 0.f, 0.f)), glm::vec3(0.f, 1.f, 0.f));
    EXPECT_EQ(mesh->barycentric(0, glm::vec3(0.f, 2.f, 0.f)), glm::vec3(0.f, 0.f, 1.f));
    EXPECT_EQ(mesh->barycentric(0, glm::vec3(1.f, 0.5f, 0.f)), glm::vec3(0.5f, 0.25f, 0.25f));
    EXPECT_EQ(mesh->barycentric(0, glm::vec3(-4.f, 0.f, 0.f)).y, -1.f);
}

TEST(TriangleMesh, UvIsInterpolatedBetweenTheCorners)
{
    EXPECT_EQ(triangle()->uv_at(0, glm::vec3(2.f, 0.f, 0.f)), glm::vec2(0.75f, 0.f));
    EXPECT_EQ(triangle()->uv_at(0, glm::vec3(1.f, 0.5f, 0.f)), glm::vec2(0.5f, 0.25f));
}

TEST(TriangleMesh, IsHitInsideOnly)
{
    Intersection isect;
    EXPECT_TRUE(triangle()->intersect(Ray(glm::vec3(1.f, 1.f, 3.f), away), &isect));
    EXPECT_EQ(isect.t, 3.f);
    EXPECT_EQ(isect.position, glm::vec3(1.f, 1.f, 0.f));
    EXPECT_EQ(isect.normal, glm::vec3(0.f, 0.f, 1.f));
    EXPECT_EQ(isect.uv, glm::vec2(0.5f, 0.5f));
    EXPECT_FALSE(triangle()->intersect(Ray(glm::vec3(3.f, 1.f, 3.f), away), &isect));
    EXPECT_FALSE(triangle()->intersect(Ray(glm::vec3(1.f, 1.f, -3.f), away), &isect));
    EXPECT_TRUE(triangle()->intersect(Ray(glm::vec3(1.f, 1.f, -3.f), -away), &isect));
}

TEST(TriangleMesh, NearestTriangleIsNamed)
{
    std::vector<TriangleMesh::Vertex> corners;
    for (float const z : {0.f, 1.f})
        for (glm::vec2 const p : {glm::vec2(-1.f, -1.f), glm::vec2(1.f, -1.f), glm::vec2(0.f, 1.f)})
            corners.push_back({glm::vec3(p, z), p});
    TriangleMesh const mesh(corners, {{0, 1, 2}, {3, 4, 5}});
    Intersection isect;
    ASSERT_TRUE(mesh.intersect(Ray(glm::vec3(0.f, 0.f, 5.f), away), &isect));
    EXPECT_EQ(isect.primitive_id, 1u);
    ASSERT_TRUE(mesh.intersect(Ray(glm::vec3(0.f, 0.f, -5.f), -away), &isect));
    EXPECT_EQ(isect.primitive_id, 0u);
}

TEST(TriangleMesh, BoundsAreThoseOfTheCorners)
{
    Bounds const bounds = triangle()->bounds(glm::translate(glm::mat4(1.f), glm::vec3(1.f, 0.f, 0.f)));
    EXPECT_EQ(bounds.lower, glm::vec3(1.f, 0.f, 0.f));
    EXPECT_EQ(bounds.upper, glm::vec3(5.f, 2.f, 0.f));
}

TEST(MeshMapping, ContinuesBeyondTheTriangle)
{
    MeshMapping const mapping(triangle());
    Intersection isect;
    isect.position = glm::vec3(8.f, 0.f, 0.f);
    EXPECT_EQ(mapping.get_uv(isect), glm::vec2(2.25f, 0.f));
}

TEST(MeshMapping, TangentIsWhereUGrows)
{
    MeshMapping const mapping(triangle());
    Intersection isect;
    isect.normal = glm::vec3(0.f, 0.f, 1.f);
    mapping.compute_tangent_space(&isect);
    EXPECT_EQ(isect.tangent, glm::vec3(1.f, 0.f, 0.f));
    EXPECT_EQ(isect.bitangent, glm::vec3(0.f, -1.f, 0.f));
}
