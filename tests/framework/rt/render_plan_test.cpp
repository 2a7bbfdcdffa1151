#include <cglib/rt/render_plan.h>

#include <cglib/core/build_paths.h>
#include <cglib/rt/scenes.h>

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

RenderPlan plan(std::string const& scene, RaytracingParameters const& params)
{
    AssetLibrary assets(assets_directory());
    return plan_render(*create_scene(scene, assets), params);
}
}  // namespace

TEST(RenderPlan, WhiteNeedsNoTexture)
{
    RenderPlan const p = plan("pooltable", with(WHITE, RECURSIVE));
    EXPECT_TRUE(p.surface_textures.empty());
    EXPECT_TRUE(p.environment);
    EXPECT_TRUE(plan("sphere", with(WHITE, RECURSIVE, true)).surface_textures.empty());
}

TEST(RenderPlan, OnlyMipFiltersNeedFootprintsAndMipLevels)
{
    EXPECT_FALSE(plan("plane", with(NEAREST, RECURSIVE)).footprints);
    EXPECT_FALSE(plan("plane", with(BILINEAR, DUDV)).footprints);
    EXPECT_TRUE(plan("plane", with(TRILINEAR, RECURSIVE)).footprints);
    EXPECT_TRUE(plan("plane", with(DEBUG_MIP, RECURSIVE)).mip_levels);
    EXPECT_FALSE(plan("plane", with(BILINEAR, RECURSIVE)).mip_levels);
}

TEST(RenderPlan, DudvReadsNoTexture)
{
    RenderPlan const p = plan("goboard", with(TRILINEAR, DUDV, true));
    EXPECT_TRUE(p.footprints_shown);
    EXPECT_FALSE(p.mip_levels || p.normal_maps || p.shading || p.environment || p.shadow_rays || p.reflected_rays);
    EXPECT_TRUE(p.surface_textures.empty());
}

TEST(RenderPlan, NormalModeReadsNormalMapsOnlyWhenTheyAreOn)
{
    EXPECT_TRUE(plan("sphere", with(NEAREST, NORMAL)).surface_textures.empty());
    EXPECT_EQ(plan("sphere", with(NEAREST, NORMAL, true)).surface_textures.size(), 2u);
    EXPECT_TRUE(plan("sphere", with(TRILINEAR, NORMAL, true)).mip_levels);
    EXPECT_FALSE(plan("sphere", with(TRILINEAR, NORMAL)).footprints);
}

TEST(RenderPlan, NormalMapsNeedASceneThatHasSome)
{
    EXPECT_FALSE(plan("plane", with(NEAREST, RECURSIVE, true)).normal_maps);
    EXPECT_TRUE(plan("sphere", with(NEAREST, RECURSIVE, true)).normal_maps);
    EXPECT_EQ(plan("sphere", with(NEAREST, RECURSIVE)).surface_textures.size(), 2u);
    EXPECT_EQ(plan("sphere", with(NEAREST, RECURSIVE, true)).surface_textures.size(), 4u);
}

TEST(RenderPlan, RaysAreFollowedOnlyWhereAMaterialSendsThem)
{
    EXPECT_FALSE(plan("plane", with(NEAREST, RECURSIVE)).reflected_rays);
    EXPECT_TRUE(plan("goboard", with(NEAREST, RECURSIVE)).reflected_rays);
    EXPECT_FALSE(plan("goboard", with(NEAREST, RECURSIVE)).transmitted_rays);
    EXPECT_TRUE(plan("triangles", with(NEAREST, RECURSIVE)).transmitted_rays);
}

TEST(RenderPlan, SwitchesLeaveRaysOut)
{
    RaytracingParameters params;
    params.shadows = params.reflection = params.transmission = false;
    RenderPlan const p = plan("triangles", params);
    EXPECT_FALSE(p.shadow_rays || p.reflected_rays || p.transmitted_rays);
    params = RaytracingParameters();
    params.max_depth = 0;
    EXPECT_FALSE(plan("goboard", params).reflected_rays);
    params.diffuse = params.specular = false;
    EXPECT_FALSE(plan("goboard", params).shadow_rays);
}

TEST(RenderPlan, UntexturedMaterialsNeedNeitherUvNorFootprint)
{
    RenderPlan const p = plan("goboard", with(TRILINEAR, RECURSIVE, true));
    Material const plain;
    EXPECT_FALSE(p.needs_uv(plain) || p.needs_footprint(plain) || p.needs_normal_map(plain));
    EXPECT_TRUE(plan("goboard", with(TRILINEAR, DUDV)).needs_footprint(plain));
}
