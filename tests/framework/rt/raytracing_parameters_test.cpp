#include <cglib/rt/raytracing_parameters.h>

#include <gtest/gtest.h>

namespace {
RaytracingParameters with(TextureFilterMode filter, RenderMode mode, bool normal_mapping = false)
{
    RaytracingParameters params;
    params.tex_filter_mode = filter;
    params.render_mode = mode;
    params.normal_mapping = normal_mapping;
    return params;
}
}  // namespace

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

TEST(RaytracingParameters, OnlyMipFiltersNeedFootprints)
{
    EXPECT_FALSE(needs_footprints(with(NEAREST, RECURSIVE)));
    EXPECT_FALSE(needs_footprints(with(BILINEAR, DUDV)));
    EXPECT_TRUE(needs_footprints(with(TRILINEAR, RECURSIVE)));
    EXPECT_TRUE(needs_footprints(with(DEBUG_MIP, DUDV)));
    EXPECT_FALSE(needs_footprints(with(TRILINEAR, NORMAL)));
    EXPECT_TRUE(needs_footprints(with(TRILINEAR, NORMAL, true)));
}

TEST(RaytracingParameters, DudvReadsNoTexture)
{
    EXPECT_FALSE(needs_mip_levels(with(TRILINEAR, DUDV)));
    EXPECT_FALSE(needs_textures(with(TRILINEAR, DUDV, true)));
    EXPECT_TRUE(needs_mip_levels(with(DEBUG_MIP, RECURSIVE)));
}
