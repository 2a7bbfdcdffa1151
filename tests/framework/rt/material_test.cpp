#include <cglib/rt/material.h>

#include <cglib/rt/texture.h>

#include <gtest/gtest.h>

namespace {
glm::vec2 const anywhere(0.3f, 0.7f);

std::shared_ptr<Texture> constant(glm::vec3 const& value)
{
    return std::make_shared<ConstTexture>(value);
}
}  // namespace

TEST(Material, DefaultIsDarkGreyAndFlat)
{
    MaterialSample const sample = Material().evaluate(anywhere, glm::vec2(0.f));
    EXPECT_EQ(sample.k_d, glm::vec3(0.18f));
    EXPECT_EQ(sample.k_s, glm::vec3(0.f));
    EXPECT_EQ(Material().evaluate_normal(anywhere, glm::vec2(0.f)), glm::vec3(0.f, 1.f, 0.f));
}

TEST(Material, AmbientIsATenthOfDiffuse)
{
    EXPECT_FLOAT_EQ(Material().evaluate(anywhere, glm::vec2(0.f)).k_a.g, 0.018f);
}

TEST(Material, CoefficientsOfAChannelSumToOneAtMost)
{
    Material material;
    material.k_d = constant(glm::vec3(1.f, 0.2f, 0.f));
    material.k_s = constant(glm::vec3(0.9f, 0.2f, 0.f));
    MaterialSample const sample = material.evaluate(anywhere, glm::vec2(0.f));
    EXPECT_FLOAT_EQ(sample.k_a.r + sample.k_d.r + sample.k_s.r, 1.f);
    EXPECT_FLOAT_EQ(sample.k_d.r, 0.5f);
    EXPECT_EQ(sample.k_s.g, 0.2f);
}

TEST(Material, BlueOfANormalMapIsTheNormalAxis)
{
    Material material;
    material.normal = constant(glm::vec3(0.9f, 0.3f, 0.6f));
    glm::vec3 const expected = glm::normalize(glm::vec3(0.8f, 0.6f, -0.4f));
    EXPECT_LT(glm::length(material.evaluate_normal(anywhere, glm::vec2(0.f)) - expected), 1e-6f);
}
