#include <cglib/rt/texture_mapping.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {
Intersection at(glm::vec3 const& position)
{
    Intersection isect;
    isect.position = position;
    return isect;
}

void expect_near(glm::vec2 const& actual, glm::vec2 const& expected)
{
    EXPECT_LT(glm::length(actual - expected), 1e-6f) << actual.x << " " << actual.y;
}
}  // namespace

TEST(ZeroMapping, IsZero)
{
    EXPECT_EQ(ZeroMapping().get_uv(at(glm::vec3(3.f))), glm::vec2(0.f));
}

TEST(UVMapping, IsThatOfTheShape)
{
    Intersection isect;
    isect.uv = glm::vec2(0.2f, 0.9f);
    EXPECT_EQ(UVMapping().get_uv(isect), isect.uv);
}

TEST(SphericalMapping, FollowsTheCompass)
{
    SphericalMapping const mapping(glm::vec3(1.f, 2.f, 3.f), 1.f);
    expect_near(mapping.get_uv(at(glm::vec3(6.f, 2.f, 3.f))), glm::vec2(0.f, 0.5f));
    expect_near(mapping.get_uv(at(glm::vec3(1.f, 2.f, -5.f))), glm::vec2(0.25f, 0.5f));
    expect_near(mapping.get_uv(at(glm::vec3(0.f, 2.f, 3.f))), glm::vec2(0.5f, 0.5f));
    expect_near(mapping.get_uv(at(glm::vec3(1.f, 2.f, 4.f))), glm::vec2(0.75f, 0.5f));
}

TEST(SphericalMapping, PolesAreTopAndBottom)
{
    SphericalMapping const mapping(glm::vec3(0.f), 5.f);
    EXPECT_EQ(mapping.get_uv(at(glm::vec3(0.f, 2.f, 0.f))).y, 5.f);
    EXPECT_NEAR(mapping.get_uv(at(glm::vec3(0.f, -2.f, 0.f))).y, 0.f, 1e-5f);
}

TEST(SphericalMapping, UStaysBelowOne)
{
    SphericalMapping const mapping(glm::vec3(0.f), 1.f);
    float const u = mapping.get_uv(at(glm::vec3(1.f, 0.f, 1e-12f))).x;
    EXPECT_GE(u, 0.f);
    EXPECT_LT(u, 1.f);
}

TEST(SphericalMapping, CentreHasFiniteUv)
{
    glm::vec2 const uv = SphericalMapping(glm::vec3(0.f), 1.f).get_uv(at(glm::vec3(0.f)));
    EXPECT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
}

TEST(PlanarMapping, VectorsScaleByTheirLength)
{
    PlanarMapping const mapping(glm::vec3(1.f, 0.f, 0.f), glm::vec3(0, 1, 0), glm::vec3(0, 0, 4), glm::vec3(2, 0, 0),
                                8.f);
    EXPECT_EQ(mapping.get_uv(at(glm::vec3(5.f, 9.f, 3.f))), glm::vec2(1.5f, 1.f));
}

TEST(PlanarMapping, TangentSpaceIsUnit)
{
    PlanarMapping const mapping(glm::vec3(0.f), glm::vec3(0, 1, 0), glm::vec3(0, 0, 4), glm::vec3(2, 0, 0), 8.f);
    Intersection isect;
    mapping.compute_tangent_space(&isect);
    EXPECT_EQ(isect.tangent, glm::vec3(0.f, 0.f, 1.f));
    EXPECT_EQ(isect.bitangent, glm::vec3(1.f, 0.f, 0.f));
}

TEST(DefaultTangentSpace, PolesPointAlongX)
{
    EXPECT_EQ(default_tangent(glm::vec3(0.f, 1.f, 0.f)), glm::vec3(1.f, 0.f, 0.f));
    EXPECT_EQ(default_tangent(glm::vec3(0.f, -1.f, 0.f)), glm::vec3(1.f, 0.f, 0.f));
}

TEST(DefaultTangentSpace, ElsewhereIsRightHandedAndHorizontal)
{
    Intersection isect;
    isect.normal = glm::normalize(glm::vec3(1.f, 2.f, 3.f));
    ZeroMapping().compute_tangent_space(&isect);
    EXPECT_LT(glm::length(isect.tangent - glm::normalize(glm::vec3(3.f, 0.f, -1.f))), 1e-6f);
    EXPECT_EQ(isect.bitangent, glm::cross(isect.tangent, isect.normal));
}
