#include <cglib/rt/raytracing_parameters.h>

#include <gtest/gtest.h>

TEST(RaytracingParameters, DefaultsAreThoseOfTheCourse)
{
    RaytracingParameters const params;
    EXPECT_EQ(params.max_depth, 4);
    EXPECT_EQ(params.ray_epsilon, 7e-3f);
    EXPECT_EQ(params.fovy, 45.f);
    EXPECT_EQ(params.spp, 1);
    EXPECT_TRUE(params.shadows && params.ambient && params.diffuse && params.specular && params.reflection);
    EXPECT_TRUE(params.transmission && params.fresnel && params.transform_objects);
    EXPECT_FALSE(params.stratified || params.normal_mapping);
    EXPECT_EQ(params.tex_filter_mode, NEAREST);
    EXPECT_EQ(params.tex_wrap_mode, REPEAT);
    EXPECT_EQ(params.render_mode, RECURSIVE);
}
